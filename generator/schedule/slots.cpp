#include "generator/schedule/slots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace finemote::gen {
namespace {

bool has_slots(BusKind kind) {
  return kind == BusKind::i2c || kind == BusKind::spi || kind == BusKind::can || kind == BusKind::rs485;
}

/// The fastest bucket with a device on the PWM segment of `expander`; the slowest bucket when nothing uses it.
std::uint32_t expander_priority(const Robot& robot, const Schedule& schedule, ExpanderId expander) {
  std::size_t fastest = schedule.buckets.empty() ? 0 : schedule.buckets.size() - 1;
  for (std::size_t i = schedule.buckets.size(); i-- > 0;) {
    for (SegmentId segment : schedule.buckets[i].flushes) {
      if (robot.segments[segment].expander == expander) fastest = i;
    }
  }
  return static_cast<std::uint32_t>(fastest);
}

std::uint32_t selector(const Device& device) {
  return device.address.value_or(device.id.value_or(device.channel.value_or(0)));
}

void report_equal_names(const Robot& robot, const std::vector<Slot>& slots, Diagnostics& diagnostics) {
  std::set<std::string> names;
  for (const Slot& slot : slots) {
    if (names.insert(slot.name).second) continue;
    const Position at = slot.device ? robot.devices[*slot.device].at : robot.expanders[*slot.expander].at;
    diagnostics
        .error(code::generated_name_clash, at, fmt::format("the generated slot name '{}' is already taken", slot.name))
        .hint("rename the device or the expander");
  }
}

}  // namespace

std::vector<Slot> plan_slots(const Robot& robot, const Forest& forest, const Schedule& schedule,
                             Diagnostics& diagnostics) {
  std::vector<Slot> slots;
  for (DeviceId device : forest.order) {
    const Device& owner = robot.devices[device];
    const auto priority = static_cast<std::uint32_t>(schedule.bucket_of[device]);
    if (owner.segment && has_slots(robot.segments[*owner.segment].bus_kind)) {
      slots.push_back(
          {*owner.segment, device, std::nullopt, selector(owner), priority, owner.name.cpp, owner.type->spi_mode});
    }
    for (const Use& use : owner.uses) {
      if (!use.segment || !has_slots(robot.segments[*use.segment].bus_kind)) continue;
      const std::string name = owner.name.cpp + "_" + use.spec->role;
      slots.push_back({*use.segment, device, std::nullopt, use.channel.value_or(0), priority, name,
                       use.spec->spi_mode.value_or(owner.type->spi_mode)});
    }
  }
  for (const ExpanderId i : robot.expanders.ids()) {
    const Expander& expander = robot.expanders[i];
    if (expander.type->is_mux()) continue;  // a mux is part of its users' transfers
    const std::uint32_t priority = expander_priority(robot, schedule, i);
    slots.push_back({expander.segment, std::nullopt, i, expander.address, priority, expander.name.cpp});
  }
  std::stable_sort(slots.begin(), slots.end(), [&](const Slot& a, const Slot& b) {
    const auto key = [&](const Slot& s) { return std::make_pair(robot.segments[s.segment].bus, s.priority); };
    return key(a) < key(b);
  });
  report_equal_names(robot, slots, diagnostics);
  return slots;
}

}  // namespace finemote::gen
