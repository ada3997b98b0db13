// What a port or its driver cannot do for the devices on it: FM3078 (an inverted line), FM3080 (more command frames
// than a CAN bus holds), FM3083 (more devices, identifiers or bytes than a bus serves, or none). The firmware would
// stop at its start, lose bytes, or be silent.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/bus/bus_type.hpp"
#include "generator/bus/line_format.hpp"
#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/connection.hpp"
#include "generator/model/reading.hpp"
#include "generator/model/shared_frame.hpp"
#include "generator/model/streamed_frames.hpp"

namespace finemote::gen {
namespace {

/// Somebody on a serial line, with the tag that names the bus.
struct LineUser {
  BusId bus;
  const Device& device;
  const std::string& format;
  const xml::Node& tag;
};

/// The ports for the kind that have an inverter, or have none.
std::vector<std::string> ports_with(const Board& board, BusKind kind, bool inverter) {
  std::vector<std::string> names;
  for (const Port& port : board.ports) {
    if (port.serves(kind) && port.has_inverter == inverter) names.push_back(port.name);
  }
  return names;
}

void check_line(Reading& reading, const LineUser& user) {
  const Port* port = reading.buses[user.bus].port;
  const bool inverted = line_format(user.format).is_inverted;
  if (port == nullptr || port->has_inverter == inverted) return;
  const xml::Attribute* bus_name = user.tag.attribute("bus");
  const std::string& device = user.device.name.text;
  const std::string message =
      inverted ? fmt::format("device '{}' needs an inverted line, and port '{}' has no inverter", device, port->name)
               : fmt::format("port '{}' inverts its line, and device '{}' needs a plain one", port->name, device);
  Diagnostic& finding = bus_name != nullptr ? at_value(reading.diagnostics, code::line_inverted, *bus_name, message)
                                            : at_tag(reading.diagnostics, code::line_inverted, user.tag, message);
  const Bus& bus = reading.robot.buses[user.bus];
  finding.note(fmt::format("bus '{}' is declared here", bus.name.text), bus.at);
  std::string ports;
  for (const std::string& name : ports_with(*reading.robot.board, bus.kind, inverted))
    ports += fmt::format("{}port=\"{}\"", ports.empty() ? "" : " or ", name);
  finding.hint(ports.empty() ? fmt::format("board '{}' has no such port", reading.robot.board->name)
                             : fmt::format("write {} at bus '{}'", ports, bus.name.text));
}

void check_lines(Reading& reading) {
  const auto check = [&](std::optional<SegmentId> segment, const Device& device, const std::string& format,
                         const xml::Node& tag) {
    if (!segment || !bus_type(reading.robot.segments[*segment].bus_kind).has_line_format) return;
    check_line(reading, {reading.robot.segments[*segment].bus, device, format, tag});
  };
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (device.type == nullptr) continue;
    check(device.segment, device, device.type->format, reading.device_tag(i));
    for (const Use& use : device.uses) check(use.segment, device, use.spec->format, use_tag(reading, i, use));
  }
}

std::string frames_text(const std::vector<std::uint32_t>& identifiers) {
  std::string text;
  for (const std::uint32_t identifier : identifiers)
    text += fmt::format("{}0x{:03X}", text.empty() ? "" : ", ", identifier);
  return text;
}

void report_frame(Reading& reading, DeviceId index, std::uint32_t identifier,
                  const std::vector<std::uint32_t>& others) {
  const Device& device = reading.robot.devices[index];
  const Bus& bus = reading.robot.buses[reading.robot.segments[*device.segment].bus];
  at_tag(reading.diagnostics, code::too_many_frames, reading.device_tag(index),
         fmt::format("device '{}' needs command frame 0x{:03X} on bus '{}', which has {} others", device.name.text,
                     identifier, bus.name.text, others.size()))
      .note(fmt::format("{}; the driver of a CAN bus keeps {} command frames", frames_text(others),
                        bus_type(bus.kind).most_shared_frames))
      .hint("put the device on another bus, or give it an id whose frame is there already");
}

/// The command frames that the devices of each bus fill together.
void check_frames(Reading& reading) {
  std::map<BusId, std::vector<std::uint32_t>> frames;
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    const auto frame = shared_frame_of(device);
    if (!frame) continue;
    const Segment& segment = reading.robot.segments[*device.segment];
    std::vector<std::uint32_t>& known = frames[segment.bus];
    if (std::find(known.begin(), known.end(), frame->identifier) != known.end()) continue;
    if (known.size() < bus_type(segment.bus_kind).most_shared_frames) {
      known.push_back(frame->identifier);
    } else {
      report_frame(reading, i, frame->identifier, known);
    }
  }
}

/// What the devices of a CAN bus send is accepted by filters: single identifiers by some, blocks by others.
struct Filters {
  std::size_t singles = 0, blocks = 0;

  [[nodiscard]] std::size_t banks() const {
    const auto filled = [](std::size_t count, std::size_t each) { return (count + each - 1) / each; };
    return filled(singles, runtime_limits::kCanIdsPerBank) + filled(blocks, runtime_limits::kCanBlocksPerBank);
  }
};

void check_filters(Reading& reading) {
  std::map<BusId, Filters> buses;
  for (const Device& device : reading.robot.devices) {
    if (device.type == nullptr || !device.segment) continue;
    Filters& filters = buses[reading.robot.segments[*device.segment].bus];
    for (const Identifiers& entry : device.type->receives) ++(entry.count == 1 ? filters.singles : filters.blocks);
  }
  for (const auto& [index, filters] : buses) {
    if (filters.banks() <= runtime_limits::kCanFilterBanks) continue;
    const Bus& bus = reading.robot.buses[index];
    at_tag(reading.diagnostics, code::bus_full, *reading.tags.buses[index],
           fmt::format("bus '{}' receives more identifiers than its filters accept", bus.name.text))
        .note(fmt::format("{} identifiers and {} blocks of them take {} filter banks, and a controller has {}: a bank "
                          "accepts {} identifiers or {} blocks",
                          filters.singles, filters.blocks, filters.banks(), runtime_limits::kCanFilterBanks,
                          runtime_limits::kCanIdsPerBank, runtime_limits::kCanBlocksPerBank))
        .hint("put some of its devices on another bus");
  }
}

Table<BusId, std::size_t> devices_per_bus(const Reading& reading) {
  Table<BusId, std::size_t> counts(reading.robot.buses.size());
  const auto count = [&](SegmentId segment) { ++counts[reading.robot.segments[segment].bus]; };
  for (const Device& device : reading.robot.devices) {
    if (device.segment) count(*device.segment);
    for (const Use& use : device.uses) {
      if (use.segment) count(*use.segment);
    }
  }
  return counts;
}

void check_counts(Reading& reading) {
  const Table<BusId, std::size_t> counts = devices_per_bus(reading);
  for (const BusId i : counts.ids()) {
    const Bus& bus = reading.robot.buses[i];
    const std::optional<std::size_t> most = bus_type(bus.kind).most_devices;
    if (!most || counts[i] <= *most) continue;
    at_tag(reading.diagnostics, code::bus_full, *reading.tags.buses[i],
           fmt::format("bus '{}' has {} devices; its driver serves {}", bus.name.text, counts[i], *most))
        .hint("put some of them on another bus");
  }
}

/// What a serial line brings from one look of its device to the next is kept until then.
void check_rings(Reading& reading) {
  const Robot& robot = reading.robot;
  for (const BusId i : robot.buses.ids()) {
    if (!bus_type(robot.buses[i].kind).has_two_lines) continue;
    if (received_bytes(robot, i) <= runtime_limits::kMostReceiveRing) continue;
    at_tag(reading.diagnostics, code::bus_full, *reading.tags.buses[i],
           fmt::format("bus '{}' may bring more than {} bytes before its device reads them", robot.buses[i].name.text,
                       runtime_limits::kMostReceiveRing))
        .note("two updates are up to two periods apart, and its driver keeps no more")
        .hint("give its device a shorter period");
  }
}

/// A transfer that the driver refuses never leaves.
void check_frame(Reading& reading, const Frame& frame, BusId id, DeviceId index, const xml::Node& tag) {
  const Port* port = reading.buses[id].port;
  if (port == nullptr || frame.stage == FrameStage::autonomous) return;
  const Bus& bus = reading.robot.buses[id];
  if (bus_type(bus.kind).is_mastered && frame.write_bytes == 0 && frame.read_bytes == 0) {
    at_tag(reading.diagnostics, code::bus_full, tag,
           fmt::format("device '{}' asks for a transfer without bytes over bus '{}'",
                       reading.robot.devices[index].name.text, bus.name.text))
        .hint("let its type say what it writes or reads, in this entry of \"frames\"");
    return;
  }
  const BusType::Longest& longest = bus_type(bus.kind).longest;
  if (longest.with_dma && (port->dma.empty() || frame.in_dma_memory)) return;
  const auto check = [&](const char* does, std::int64_t bytes, std::optional<std::int64_t> most) {
    if (!most || bytes <= *most) return;
    at_tag(reading.diagnostics, code::bus_full, tag,
           fmt::format("device '{}' {} {} bytes at once over bus '{}'; its driver takes {}",
                       reading.robot.devices[index].name.text, does, bytes, bus.name.text, *most))
        .hint("let its type do so in several transfers, with an entry of \"frames\" for each");
  };
  check("writes", frame.write_bytes, longest.written);
  check("reads", frame.read_bytes, longest.read);
}

void check_lengths(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (device.type == nullptr) continue;
    for (const Connection& connection : connections_of(device)) {
      const BusId bus = reading.robot.segments[connection.segment].bus;
      const xml::Node& tag = connection.use != nullptr ? use_tag(reading, i, *connection.use) : reading.device_tag(i);
      for (const Frame& frame : frames_over(device, connection)) check_frame(reading, frame, bus, i, tag);
    }
  }
}

}  // namespace

void check_driver_limits(Reading& reading) {
  if (reading.robot.board == nullptr) return;
  check_lines(reading);
  check_frames(reading);
  check_filters(reading);
  check_counts(reading);
  check_rings(reading);
  check_lengths(reading);
}

}  // namespace finemote::gen
