#include "generator/run/check_wcet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

struct Extremes {
  std::int64_t shortest = std::numeric_limits<std::int64_t>::max();  ///< ns; this value: the stage never ended
  std::int64_t longest = 0;                                          ///< ns
};
using Stages = std::array<Extremes, 2>;  ///< of update(), of handle()

struct Running {
  DeviceId device;
  bool is_handle = false;
  std::int64_t alone_ns = 0;  ///< so far, without the stages that interrupted it
};

/// Extremes of every device's stages, the time of interrupting stages taken out.
Table<DeviceId, Stages> stage_extremes(const RunRecord& record, std::size_t devices) {
  Table<DeviceId, Stages> result(devices);
  std::vector<Running> open;  // the one that runs is last
  std::int64_t last = 0;
  for (const Event& event : record.events) {
    if (!open.empty()) open.back().alone_ns += event.t_ns - last;
    last = event.t_ns;
    if (!event.is_end) {
      open.push_back({event.device, event.is_handle});
      continue;
    }
    const bool is_whole =
        !open.empty() && open.back().device == event.device && open.back().is_handle == event.is_handle;
    if (!is_whole) {  // its begin was lost, by a reset for example
      open.clear();
      continue;
    }
    Extremes& seen = result[event.device][event.is_handle ? 1 : 0];
    seen.shortest = std::min(seen.shortest, open.back().alone_ns);
    seen.longest = std::max(seen.longest, open.back().alone_ns);
    open.pop_back();
  }
  return result;
}

/// A quarter more, to two digits: what one run has not shown.
std::int64_t with_margin(std::int64_t seen_ns) {
  std::int64_t unit = 1;
  const std::int64_t wanted = seen_ns + seen_ns / 4;
  while (wanted / unit >= 100) unit *= 10;
  return (wanted + unit - 1) / unit * unit;
}

/// None where a stage never ran: what was not measured is not called so.
std::optional<MeasuredWcet> measured_wcet(DeviceId device, const Stages& seen) {
  if (seen[0].longest == 0 || seen[1].longest == 0) return std::nullopt;
  return MeasuredWcet{device, with_margin(seen[0].longest), with_margin(seen[1].longest)};
}

void warn(const Device& device, DeviceId index, const Stages& seen, std::int64_t stage_cost_ns,
          Diagnostics& diagnostics) {
  constexpr std::array<const char*, 2> kNames = {"update", "handle"};
  const std::array<std::int64_t, 2> wcet = {device.wcet.update_ns, device.wcet.handle_ns};
  std::string said;
  for (std::size_t i = 0; i < wcet.size(); ++i) {
    const bool ran = seen[i].longest > 0;
    if (!ran || seen[i].shortest - stage_cost_ns <= wcet[i]) continue;
    said += fmt::format("{}{}() never took less than {} us, its WCET is {}", said.empty() ? "" : "; ", kNames[i],
                        (seen[i].shortest - stage_cost_ns) / 1000.0, units::format_duration(wcet[i]));
  }
  if (said.empty()) return;
  auto& finding = diagnostics.warning(code::wcet_exceeded, device.at, fmt::format("'{}': {}", device.name.text, said));
  if (device.wcet.source == Wcet::Source::assumed)
    finding.note("this WCET is the type's default: the device gives none");
  const auto measured = measured_wcet(index, seen);
  if (measured) {
    finding.hint(fmt::format("write {}: the longest run seen and a quarter", wcet_element(*measured)));
  } else {
    finding.hint("let the run last until both stages have run: then it offers the measured <wcet>");
  }
}

}  // namespace

void check_wcet(const Robot& robot, const RunRecord& record, std::int64_t stage_cost_ns, Diagnostics& diagnostics) {
  const Table<DeviceId, Stages> seen = stage_extremes(record, robot.devices.size());
  for (const DeviceId i : robot.devices.ids()) warn(robot.devices[i], i, seen[i], stage_cost_ns, diagnostics);
}

std::vector<MeasuredWcet> measured_wcets(const Robot& robot, const RunRecord& record) {
  const Table<DeviceId, Stages> seen = stage_extremes(record, robot.devices.size());
  std::vector<MeasuredWcet> list;
  for (const DeviceId i : robot.devices.ids()) {
    const auto measured = measured_wcet(i, seen[i]);
    if (robot.devices[i].wcet.source == Wcet::Source::assumed && measured) list.push_back(*measured);
  }
  return list;
}

std::string wcet_element(const MeasuredWcet& wcet) {
  return fmt::format("<wcet update=\"{}\" handle=\"{}\" source=\"measured\"/>", units::format_duration(wcet.update_ns),
                     units::format_duration(wcet.handle_ns));
}

}  // namespace finemote::gen
