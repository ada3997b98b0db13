// Channels of pulse outputs, chip selects and pins: which one each device and <use> has. FM3064, FM3065.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/places.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Channels = BusType::Channels;

Channels channels_of(const Reading& reading, SegmentId segment) {
  return bus_type(reading.robot.segments[segment].bus_kind).channels;
}

/// Pulse outputs or chip selects of a segment; 0: it has none, or they are not known.
std::uint32_t use_channels(const Reading& reading, SegmentId segment) {
  const Channels channels = channels_of(reading, segment);
  return channels == Channels::outputs || channels == Channels::selects ? channel_count(reading, segment) : 0;
}

std::string example_channel(const Reading& reading, SegmentId segment, std::uint32_t count) {
  const std::vector<std::uint32_t> free = free_channels(reading, segment, count);
  return free.empty() ? "none is free: name another bus" : fmt::format("add for example channel=\"{}\"", free.front());
}

/// What could be written instead of a channel that is taken.
std::string other_channels(const Reading& reading, SegmentId segment) {
  constexpr std::size_t kMost = 8;
  const std::vector<std::uint32_t> free = free_channels(reading, segment, channel_count(reading, segment));
  std::string list;
  for (std::size_t i = 0; i < free.size() && i < kMost; ++i) list += (i > 0 ? ", " : "") + std::to_string(free[i]);
  if (list.empty()) return "no channel of it is free: put one of them on another bus";
  return fmt::format("channels that are free here: {}{}", list, free.size() > kMost ? ", ..." : "");
}

}  // namespace

void read_channel(const Placing& at) {
  if (!at.applies("channel", at.type.needs_channel)) return;
  const xml::Attribute* attribute = at.tag.attribute("channel");
  const bool has_place = at.device.segment.has_value() && !at.bus_is_wrong;
  const std::uint32_t count = has_place ? channel_count(at.reading, *at.device.segment) : 0;
  if (attribute == nullptr) {
    if (count == 1) at.device.channel = 0;
    return;  // more: report_missing_places()
  }
  const auto channel = read_quantity(at.tag, "channel", units::parse_bare, at.diagnostics());
  if (!channel) return;
  const std::uint32_t least = at.type.channel_min.value_or(0);
  const std::uint32_t most = std::min(at.type.channel_max.value_or(UINT32_MAX), count > 0 ? count - 1 : UINT32_MAX);
  if (*channel >= least && *channel <= most) {
    at.device.channel = *channel;
    return;
  }
  at_value(at.diagnostics(), code::channel_range, *attribute,
           fmt::format("bus '{}' has no channel {}", value_of(at.tag, "bus"), *channel))
      .hint(least == most ? fmt::format("its only channel is {}", most)
                          : fmt::format("its channels are {} to {}", least, most));
}

/// The pulse output or chip select that a device uses: as one that it sits on.
void resolve_use_channels(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    for (Use& use : reading.robot.devices[i].uses) {
      if (!use.segment) continue;
      const Segment& segment = reading.robot.segments[*use.segment];
      const std::uint32_t count = use_channels(reading, *use.segment);
      if (count == 0) continue;
      const xml::Node& tag = use_tag(reading, i, use);
      const xml::Attribute* attribute = tag.attribute("channel");
      if (!use.channel && attribute == nullptr) {
        if (count == 1) {
          use.channel = 0;
        } else {
          at_tag(reading.diagnostics, code::attribute_missing, tag,
                 fmt::format("<use role=\"{}\"> has no 'channel'", use.spec->role))
              .hint(example_channel(reading, *use.segment, count));
        }
      }
      if (!use.channel || *use.channel < count || attribute == nullptr) continue;
      at_value(reading.diagnostics, code::channel_range, *attribute,
               fmt::format("bus '{}' has no channel {}", segment.name.text, *use.channel))
          .hint(count == 1 ? "its only channel is 0" : fmt::format("its channels are 0 to {}", count - 1));
    }
  }
}

/// A pulse output, a chip select or a pin belongs to one device, in one role.
void check_channels(Reading& reading) {
  std::map<std::pair<SegmentId, std::uint32_t>, Occupant> users;
  const auto take = [&](SegmentId segment, std::uint32_t channel, const Occupant& self) {
    const auto [first, is_fresh] = users.emplace(std::make_pair(segment, channel), self);
    if (is_fresh) return;
    auto& finding =
        at_place(reading.diagnostics, code::channel_twice, self, "channel",
                 fmt::format("channel {} of '{}' is used twice", channel, reading.robot.segments[segment].name.text));
    finding.note(fmt::format("{} uses it already", first->second.what), first->second.tag->at);
    if (channels_of(reading, segment) == Channels::outputs) finding.hint(other_channels(reading, segment));
  };
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    const Occupant self = describe(reading, i);
    if (device.segment && device.channel) take(*device.segment, *device.channel, self);
    for (const Use& use : device.uses) {
      if (use.segment && use.channel) {
        take(*use.segment, *use.channel,
             {fmt::format("{} (use '{}')", self.what, use.spec->role), &use_tag(reading, i, use)});
      }
    }
  }
}

std::uint32_t channel_count(const Reading& reading, SegmentId index) {
  const Segment& segment = reading.robot.segments[index];
  if (segment.kind == Segment::Kind::pwm_expander) return reading.robot.expanders[*segment.expander].type->channels;
  const Board* board = reading.robot.board;
  if (channels_of(reading, index) == Channels::pins)
    return board != nullptr ? static_cast<std::uint32_t>(board->pins.size()) : 0;
  const Port* port = reading.buses[segment.bus].port;
  return port != nullptr ? std::max(1U, port->channels) : 0;
}

std::vector<std::uint32_t> free_channels(const Reading& reading, SegmentId segment, std::uint32_t count) {
  std::set<std::uint32_t> taken;
  for (const Device& device : reading.robot.devices) {
    if (device.segment == segment && device.channel) taken.insert(*device.channel);
    for (const Use& use : device.uses) {
      if (use.segment == segment && use.channel) taken.insert(*use.channel);
    }
  }
  std::vector<std::uint32_t> free;
  for (std::uint32_t channel = 0; channel < count; ++channel) {
    if (!taken.contains(channel)) free.push_back(channel);
  }
  return free;
}

}  // namespace finemote::gen
