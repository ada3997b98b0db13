#include "generator/run/check_wcet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "generator/forest/stage.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Stages = std::array<std::optional<Duration>, 2>;  ///< longest own time of update(), of handle()

Table<DeviceId, Stages> longest_stages(const RunRecord& record, std::size_t devices) {
  Table<DeviceId, Stages> result(devices);
  for (const OwnTime& own : record.own_times) result[own.device][own.is_handle ? 1 : 0] = own.longest;
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
  if (!seen[0] || !seen[1]) return std::nullopt;
  return MeasuredWcet{device, with_margin(*seen[0]), with_margin(*seen[1])};
}

/// A device whose part is silent, or never came up, has not done its longest work.
bool has_worked(const Device& device, const RunRecord& record) {
  const auto is_in = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), device.name.text) != names.end();
  };
  return !is_in(record.silent) && !is_in(record.absent);
}

bool check(const Device& device, DeviceId index, const Wcet& given, const Stages& seen, Diagnostics& diagnostics) {
  const std::array<Duration, 2> wcet = {given.update, given.handle};
  std::string said;
  for (std::size_t i = 0; i < wcet.size(); ++i) {
    if (!seen[i] || *seen[i] <= wcet[i]) continue;
    said += fmt::format("{}{}() took {} us by itself, its WCET is {}", said.empty() ? "" : "; ", stage_name(i == 1),
                        seen[i]->ns() / 1000.0, units::format_duration(wcet[i]));
  }
  if (said.empty()) return true;
  auto& finding = diagnostics.error(code::wcet_exceeded, device.at, fmt::format("'{}': {}", device.name.text, said));
  if (device.wcet.source == Wcet::Source::assumed)
    finding.note("this WCET is the type's default: the device gives none");
  const auto measured = measured_wcet(index, seen);
  if (measured) {
    finding.hint(fmt::format("write {}: the longest run seen plus 25 %", wcet_element(*measured)));
  } else {
    finding.hint("let the run last until both stages have run: then it offers the measured <wcet>");
  }
  return false;
}

}  // namespace

Table<DeviceId, Wcet> analysed_wcets(const Robot& robot, const Forest& forest, const timing::Model& model) {
  Table<DeviceId, Wcet> wcets(robot.devices.size());
  for (const Rank rank : forest.order.ids()) {
    Wcet& wcet = wcets[forest.order[rank]] = robot.devices[forest.order[rank]].wcet;
    wcet.update = model.devices[rank].update_wcet;
    wcet.handle = model.devices[rank].handle_wcet;
  }
  return wcets;
}

bool check_wcet(const Robot& robot, const Table<DeviceId, Wcet>& wcets, const RunRecord& record,
                Diagnostics& diagnostics) {
  const Table<DeviceId, Stages> seen = longest_stages(record, robot.devices.size());
  bool holds = true;
  for (const DeviceId i : robot.devices.ids())
    holds = check(robot.devices[i], i, wcets[i], seen[i], diagnostics) && holds;
  return holds;
}

std::vector<MeasuredWcet> measured_wcets(const Robot& robot, const RunRecord& record) {
  const Table<DeviceId, Stages> seen = longest_stages(record, robot.devices.size());
  std::vector<MeasuredWcet> list;
  for (const DeviceId i : robot.devices.ids()) {
    const auto measured = measured_wcet(i, seen[i]);
    const bool is_assumed = robot.devices[i].wcet.source == Wcet::Source::assumed;
    if (is_assumed && measured && has_worked(robot.devices[i], record)) list.push_back(*measured);
  }
  return list;
}

std::string wcet_element(const MeasuredWcet& wcet) {
  return fmt::format("<wcet update=\"{}\" handle=\"{}\" source=\"measured\"/>", units::format_duration(wcet.update),
                     units::format_duration(wcet.handle));
}

}  // namespace finemote::gen
