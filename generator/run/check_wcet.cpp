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
  Duration shortest = Duration::max();  ///< this value: the stage never ended
  Duration longest;
};
using Stages = std::array<Extremes, 2>;  ///< of update(), of handle()

struct Running {
  DeviceId device;
  bool is_handle = false;
  Duration alone;  ///< so far, without the stages that interrupted it
};

/// Extremes of every device's stages, the time of interrupting stages taken out.
Table<DeviceId, Stages> stage_extremes(const RunRecord& record, std::size_t devices) {
  Table<DeviceId, Stages> result(devices);
  std::vector<Running> open;  // the one that runs is last
  Duration last;
  for (const Event& event : record.events) {
    if (!open.empty()) open.back().alone += event.at - last;
    last = event.at;
    if (!event.is_end) {
      open.push_back({event.device, event.is_handle, Duration::zero()});
      continue;
    }
    const bool is_whole =
        !open.empty() && open.back().device == event.device && open.back().is_handle == event.is_handle;
    if (!is_whole) {  // its begin was lost, by a reset for example
      open.clear();
      continue;
    }
    Extremes& seen = result[event.device][event.is_handle ? 1 : 0];
    seen.shortest = std::min(seen.shortest, open.back().alone);
    seen.longest = std::max(seen.longest, open.back().alone);
    open.pop_back();
  }
  return result;
}

/// A quarter more, to two digits: what one run has not shown.
Duration with_margin(Duration seen) {
  Duration unit = nanoseconds(1);
  const Duration wanted = seen + floor_div(seen, 4);
  while (floor_div(wanted, unit) >= 100) unit = 10 * unit;
  return round_up(wanted, unit);
}

/// None where a stage never ran: what was not measured is not called so.
std::optional<MeasuredWcet> measured_wcet(DeviceId device, const Stages& seen) {
  if (seen[0].longest == Duration::zero() || seen[1].longest == Duration::zero()) return std::nullopt;
  return MeasuredWcet{device, with_margin(seen[0].longest), with_margin(seen[1].longest)};
}

void warn(const Device& device, DeviceId index, const Stages& seen, Duration stage_cost, Diagnostics& diagnostics) {
  constexpr std::array<const char*, 2> kNames = {"update", "handle"};
  const std::array<Duration, 2> wcet = {device.wcet.update, device.wcet.handle};
  std::string said;
  for (std::size_t i = 0; i < wcet.size(); ++i) {
    const bool ran = seen[i].longest > Duration::zero();
    if (!ran || seen[i].shortest - stage_cost <= wcet[i]) continue;
    said += fmt::format("{}{}() never took less than {} us, its WCET is {}", said.empty() ? "" : "; ", kNames[i],
                        (seen[i].shortest - stage_cost).ns() / 1000.0, units::format_duration(wcet[i]));
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

void check_wcet(const Robot& robot, const RunRecord& record, Duration stage_cost, Diagnostics& diagnostics) {
  const Table<DeviceId, Stages> seen = stage_extremes(record, robot.devices.size());
  for (const DeviceId i : robot.devices.ids()) warn(robot.devices[i], i, seen[i], stage_cost, diagnostics);
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
  return fmt::format("<wcet update=\"{}\" handle=\"{}\" source=\"measured\"/>", units::format_duration(wcet.update),
                     units::format_duration(wcet.handle));
}

}  // namespace finemote::gen
