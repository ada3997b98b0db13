#include "generator/run/traffic.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/model/connection.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/timing/traffic_limits.hpp"
#include "generator/units/checked.hpp"
#include "generator/units/slow_sender.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// In a window of true time, while the model counts by the board's clock. None: the numbers are too large.
std::optional<Table<timing::BusPlace, timing::TrafficLimit>> limits_of(const Robot& robot, const timing::Model& model,
                                                                       Duration window) {
  try {
    return timing::traffic_limits(model, longest_counted(robot, window));
  } catch (const Overflow&) {
    return std::nullopt;
  }
}

/// Where parts declare nothing on a line that the board receives on, no bound rests on what comes there.
Declared<Duration> received(const BusTraffic& seen, const timing::TrafficLimit& limit, bool is_text) {
  const bool is_bound = !is_text && limit.received && *limit.received > Duration::zero();
  return {seen.received, is_bound ? std::optional(of_slow_sender(*limit.received)) : std::nullopt};
}

/// The most data bytes of a transfer that a device declares; none: it declares nothing, or has none of its own.
std::optional<std::int64_t> longest_declared(const Device& device) {
  if (!device.type->frames) return std::nullopt;
  std::int64_t longest = 0;
  for (const Frame& frame : frames_over(device, connections_of(device).front()))
    longest = std::max(longest, frame.write_bytes + frame.read_bytes);
  return longest;
}

/// Of the devices with an address on a bus, behind muxes or not: the one that declares most; none where one of them
/// declares nothing.
std::optional<LongTransfer> most_declared(const Robot& robot, BusId bus, std::uint32_t address) {
  std::optional<LongTransfer> most;
  for (const DeviceId id : robot.devices.ids()) {
    const Device& device = robot.devices[id];
    if (device.address != address || !device.segment || robot.segments[*device.segment].bus != bus) continue;
    const std::optional<std::int64_t> declared = longest_declared(device);
    if (!declared) return std::nullopt;
    if (!most || *most->bytes.most < *declared) most = LongTransfer{id, {0, declared}};
  }
  return most;
}

std::vector<LongTransfer> too_long_transfers(const Robot& robot, BusId bus, const BusTraffic& seen) {
  std::vector<LongTransfer> found;
  for (const auto& [address, bytes] : seen.longest) {
    std::optional<LongTransfer> most = most_declared(robot, bus, address);
    if (!most || bytes <= *most->bytes.most) continue;
    most->bytes.seen = bytes;
    found.push_back(*most);
  }
  return found;
}

MeasuredTraffic measured(const Robot& robot, BusId bus, const BusTraffic& seen, const timing::TrafficLimit& limit,
                         bool is_text) {
  MeasuredTraffic traffic{bus, seen.window, {seen.sent, limit.wire}, std::nullopt, {seen.interrupts, limit.interrupts}};
  if (bus_type(robot.buses[bus].kind).has_two_lines) {
    traffic.received = received(seen, limit, is_text);
  } else {
    traffic.sent.seen += seen.received;  // of a line that is switched over
  }
  traffic.too_long = too_long_transfers(robot, bus, seen);
  return traffic;
}

}  // namespace

Judgement MeasuredTraffic::judged() const {
  const Judgement of_received = received ? received->judged() : Judgement::no_bound;
  if (!too_long.empty()) return Judgement::broken;
  const auto any = [&](Judgement one) {
    return sent.judged() == one || of_received == one || interrupts.judged() == one;
  };
  return any(Judgement::broken) ? Judgement::broken : any(Judgement::held) ? Judgement::held : Judgement::no_bound;
}

std::vector<MeasuredTraffic> measure_traffic(const Robot& robot, const timing::Model& model, const RunRecord& record) {
  std::vector<MeasuredTraffic> all;
  const timing::BusPlaces places(robot);
  std::optional<Table<timing::BusPlace, timing::TrafficLimit>> limits;
  for (const BusRecord& bus : record.buses) {
    const auto place = places.of(bus.bus);
    if (!place || !bus.traffic) continue;
    if (!limits) limits = limits_of(robot, model, bus.traffic->window);  // of all the same
    if (!limits) return all;
    const auto& texts = record.text_ports;
    const bool is_text = std::find(texts.begin(), texts.end(), robot.buses[bus.bus].port) != texts.end();
    all.push_back(measured(robot, bus.bus, *bus.traffic, (*limits)[*place], is_text));
  }
  return all;
}

const MeasuredTraffic* find_traffic(const std::vector<MeasuredTraffic>& all, BusId bus) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const MeasuredTraffic& t) { return t.bus == bus; });
  return found == all.end() ? nullptr : &*found;
}

namespace {

template <class Amount, class Text>
void say(std::vector<std::string>& said, const char* what, const Declared<Amount>& amount, const Text& text) {
  if (amount.judged() != Judgement::broken) return;
  said.push_back(fmt::format("{} {} (declared: at most {})", what, text(amount.seen), text(*amount.most)));
}

/// Devices on a bus, those of types of the user's first: shipped ones declare what they send.
std::vector<std::string> devices_on(const Robot& robot, BusId bus, bool builtin) {
  std::vector<std::string> names;
  for (const Device& device : robot.devices) {
    const std::vector<Connection> connections = connections_of(device);
    const bool is_here = std::any_of(connections.begin(), connections.end(), [&](const Connection& connection) {
      return robot.segments[connection.segment].bus == bus;
    });
    if (is_here && device.type->builtin == builtin) names.push_back("'" + device.name.text + "'");
  }
  return names;
}

constexpr const char* kWhyDeclared =
    "bounds of chains over this bus, and of what its interrupts delay, are made from what is declared";

void report_long(const Robot& robot, const MeasuredTraffic& traffic, Diagnostics& diagnostics) {
  for (const LongTransfer& transfer : traffic.too_long) {
    const Device& device = robot.devices[transfer.device];
    diagnostics
        .error(code::undeclared_traffic, device.at,
               fmt::format("device '{}' moves {} bytes in one transfer over bus '{}'; its type declares {} at most",
                           device.name.text, transfer.bytes.seen, robot.buses[traffic.bus].name.text,
                           *transfer.bytes.most))
        .note(kWhyDeclared)
        .hint(fmt::format("let 'frames' in the descriptor of '{}' say the bytes of its longest transfer",
                          device.type->name));
  }
}

bool check(const Robot& robot, const MeasuredTraffic& traffic, Diagnostics& diagnostics) {
  report_long(robot, traffic, diagnostics);
  std::vector<std::string> said;
  const auto time = [](Duration duration) { return fmt::format("{:.3f} ms", duration.ns() / 1e6); };
  const auto count = [](std::int64_t number) { return fmt::format("{} time{}", number, number == 1 ? "" : "s"); };
  say(said, traffic.received ? "it sent for" : "its wire was in use for", traffic.sent, time);
  if (traffic.received) say(said, "it received for", *traffic.received, time);
  say(said, "its interrupts ran", traffic.interrupts, count);
  if (said.empty()) return traffic.too_long.empty();
  const Bus& bus = robot.buses[traffic.bus];
  auto& finding = diagnostics.error(code::undeclared_traffic, bus.at,
                                    fmt::format("more goes over bus '{}' than its devices declare: in {} {}",
                                                bus.name.text, time(traffic.window), fmt::join(said, "; ")));
  finding.note(kWhyDeclared);
  const std::vector<std::string> own = devices_on(robot, traffic.bus, false);
  if (own.empty()) return false;
  finding.hint(fmt::format("let 'frames' in the descriptors of {} say all that they and their parts send",
                           fmt::join(own, ", ")));
  return false;
}

}  // namespace

bool check_traffic(const Robot& robot, const std::vector<MeasuredTraffic>& traffic, Diagnostics& diagnostics) {
  bool holds = true;
  for (const MeasuredTraffic& of_bus : traffic) holds = check(robot, of_bus, diagnostics) && holds;
  return holds;
}

}  // namespace finemote::gen
