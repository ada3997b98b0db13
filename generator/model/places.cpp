// Where each device sits on its bus, and what is missing there: FM3010, FM3018, and FM3066 for a line with two devices.
#include "generator/model/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/model/attributes.hpp"

namespace finemote::gen {
namespace {

/// Channels and ids that were offered to others already, by segment.
using Offered = std::set<std::pair<SegmentId, std::uint32_t>>;

void report_none_free(const Placing& at, const char* name) {
  if (at.reading.tags.is_misspelt(at.tag, name)) return;
  at_tag(at.diagnostics(), code::attribute_missing, at.tag,
         fmt::format("device '{}' has no '{}'", at.device.name.text, name))
      .hint(fmt::format("none is free on '{}': put the device on another bus", value_of(at.tag, "bus")));
}

void offer(const Placing& at, const char* name, const std::vector<std::uint32_t>& free, std::uint32_t least,
           Offered& offered) {
  const auto found = std::find_if(free.begin(), free.end(), [&](std::uint32_t number) {
    return number >= least && !offered.contains({*at.device.segment, number});
  });
  if (found == free.end()) return report_none_free(at, name);
  offered.insert({*at.device.segment, *found});
  at.report_missing(name, std::to_string(*found));
}

/// Reports a channel or an id that is not there, once the places of all devices are known: it offers a free one.
void report_missing_places(const Placing& at, Offered& offered) {
  if (at.bus_is_wrong || !at.device.segment) return;
  const SegmentId segment = *at.device.segment;
  const std::uint32_t count = channel_count(at.reading, segment);
  if (at.type.needs_channel && count > 1 && at.tag.attribute("channel") == nullptr) {
    const std::uint32_t end = std::min(count, at.type.channel_max.value_or(UINT32_MAX - 1) + 1);
    offer(at, "channel", free_channels(at.reading, segment, end), at.type.channel_min.value_or(0), offered);
  }
  if (at.type.needs_id && at.tag.attribute("id") == nullptr)
    offer(at, "id", free_ids(at.reading, at.type, segment), at.type.id_min.value_or(0), offered);
}

/// A serial line carries one device; `use` counts.
void check_exclusive(Reading& reading) {
  std::map<SegmentId, Occupant> users;
  const auto take = [&](SegmentId segment, const Occupant& occupant) {
    if (!bus_type(reading.robot.segments[segment].bus_kind).is_for_one) return;
    const auto [first, is_fresh] = users.emplace(segment, occupant);
    if (is_fresh) return;
    at_place(reading.diagnostics, code::bus_shared, occupant, "bus",
             fmt::format("uart bus '{}' has two devices", reading.robot.segments[segment].name.text))
        .note(fmt::format("{} uses it already", first->second.what), first->second.tag->at)
        .hint(
            "a uart connects two ends: give each device its own bus, or use type=\"rs485\" for parts that share a "
            "line");
  };
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    const Occupant self = describe(reading, i);
    if (device.segment) take(*device.segment, self);
    for (const Use& use : device.uses) {
      if (use.segment) take(*use.segment, {self.what, &use_tag(reading, i, use)});
    }
  }
}

/// Calls `act` with every device whose type is known.
template <typename Act>
void each_placing(Reading& reading, const Act& act) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    if (reading.robot.devices[i].type != nullptr) act(Placing(reading, i));
  }
}

}  // namespace

Placing::Placing(Reading& all, DeviceId id)
    : reading(all),
      device(all.robot.devices[id]),
      type(*device.type),
      tag(all.device_tag(id)),
      bus_is_wrong(all.devices[id].bus_is_wrong) {}

bool Placing::applies(const char* name, bool is_needed) const {
  const xml::Attribute* attribute = tag.attribute(name);
  if (is_needed || attribute == nullptr || type.has_mistakes) return is_needed;
  auto& finding = diagnostics()
                      .error(code::attribute_unused, attribute->at, fmt::format("'{}' has no '{}'", type.name, name))
                      .underline(attribute->name.size())
                      .hint(fmt::format("remove {}=\"{}\"", name, attribute->value));
  if (!type.builtin && !type.buses.empty())
    finding.hint(
        fmt::format("or let the devices of this type have one: \"{}\" in \"bus\" of '{}'", name, type.display_path));
  return false;
}

void Placing::report_missing(const char* name, const std::string& example) const {
  if (bus_is_wrong || !device.segment || reading.tags.is_misspelt(tag, name)) return;
  at_tag(diagnostics(), code::attribute_missing, tag, fmt::format("device '{}' has no '{}'", device.name.text, name))
      .hint(fmt::format("add for example {}=\"{}\"", name, example));
}

Occupant describe(const Reading& reading, DeviceId device) {
  return {fmt::format("device '{}'", reading.robot.devices[device].name.text), &reading.device_tag(device)};
}

Diagnostic& at_place(Diagnostics& diagnostics, Code code, const Occupant& occupant, std::string_view attribute,
                     std::string message) {
  const xml::Attribute* found = occupant.tag->attribute(attribute);
  return found != nullptr ? at_value(diagnostics, code, *found, std::move(message))
                          : at_tag(diagnostics, code, *occupant.tag, std::move(message));
}

const xml::Node& use_tag(const Reading& reading, DeviceId device, const Use& use) {
  const xml::Node& tag = reading.device_tag(device);
  for (const xml::Node& child : tag.children) {
    if (child.is_element("use") && child.at.line == use.at.line && child.at.column == use.at.column) return child;
  }
  return tag;
}

void resolve_places(Reading& reading) {
  each_placing(reading, [](const Placing& at) {
    read_address(at);
    read_channel(at);
    read_id(at);
  });
  resolve_use_channels(reading);
  Offered offered;
  each_placing(reading, [&](const Placing& at) { report_missing_places(at, offered); });
  check_addresses(reading);
  check_exclusive(reading);
  check_channels(reading);
  check_ids(reading);
  check_shared_frames(reading);
}

}  // namespace finemote::gen
