// Where each device sits on its bus: address, channel, id. FM3010, FM3018, FM3061 to FM3069.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/model/address.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// Reads the attributes of one device that say its place.
class PlaceReader {
 public:
  PlaceReader(Reading& reading, DeviceId index)
      : reading_(reading),
        diagnostics_(reading.diagnostics),
        device_(reading.robot.devices[index]),
        type_(*device_.type),
        tag_(reading.device_tag(index)),
        bus_is_wrong_(reading.devices[index].bus_is_wrong) {}

  void read() {
    read_address();
    read_channel();
    read_id();
  }

  /// Channels and ids that were offered to others already, by segment.
  using Offered = std::set<std::pair<SegmentId, std::uint32_t>>;

  /// Reports a channel or an id that is not there, once the places of all devices are known: it offers a free one.
  void report_missing_places(Offered& offered) {
    if (bus_is_wrong_ || !device_.segment) return;
    const SegmentId segment = *device_.segment;
    const std::uint32_t count = channel_count(reading_, segment);
    if (type_.needs_channel && count > 1 && tag_.attribute("channel") == nullptr) {
      const std::uint32_t end = std::min(count, type_.channel_max.value_or(UINT32_MAX - 1) + 1);
      offer("channel", free_channels(reading_, segment, end), type_.channel_min.value_or(0), offered);
    }
    if (type_.needs_id && tag_.attribute("id") == nullptr)
      offer("id", free_ids(reading_, type_, segment), type_.id_min.value_or(0), offered);
  }

 private:
  void offer(const char* name, const std::vector<std::uint32_t>& free, std::uint32_t least, Offered& offered) {
    const auto found = std::find_if(free.begin(), free.end(), [&](std::uint32_t number) {
      return number >= least && !offered.contains({*device_.segment, number});
    });
    if (found == free.end()) return report_none_free(name);
    offered.insert({*device_.segment, *found});
    report_missing(name, std::to_string(*found));
  }
  void report_none_free(const char* name) {
    if (reading_.tags.is_misspelt(tag_, name)) return;
    at_tag(diagnostics_, code::attribute_missing, tag_, fmt::format("device '{}' has no '{}'", device_.name.text, name))
        .hint(fmt::format("none is free on '{}': put the device on another bus", value_of(tag_, "bus")));
  }
  /// True when the attribute may stand here; reports it otherwise.
  bool applies(const char* name, bool is_needed) {
    const xml::Attribute* attribute = tag_.attribute(name);
    if (is_needed || attribute == nullptr) return is_needed;
    diagnostics_.error(code::attribute_unused, attribute->at, fmt::format("'{}' has no '{}'", type_.name, name))
        .underline(attribute->name.size())
        .hint(fmt::format("remove {}=\"{}\"", name, attribute->value));
    return false;
  }
  void report_missing(const char* name, const std::string& example) {
    if (bus_is_wrong_ || !device_.segment || reading_.tags.is_misspelt(tag_, name)) return;
    at_tag(diagnostics_, code::attribute_missing, tag_, fmt::format("device '{}' has no '{}'", device_.name.text, name))
        .hint(fmt::format("add for example {}=\"{}\"", name, example));
  }
  void read_address() {
    if (!applies("address", type_.needs_address)) return;
    const xml::Attribute* attribute = tag_.attribute("address");
    if (attribute == nullptr) {
      device_.address = type_.default_address;
      if (!device_.address)
        report_missing("address", type_.addresses.empty() ? "0x76" : fmt::format("0x{:02x}", type_.addresses.front()));
      return;
    }
    const auto address = read_quantity(tag_, "address", units::parse_bare, diagnostics_);
    if (!address) return;
    const bool is_good = check_address(diagnostics_, *attribute, *address, type_.addresses, type_.name);
    // a wrong address that was surely meant as another one takes part in the search for conflicts as that
    if (is_good || is_8bit_address(*address, type_.addresses)) device_.address = is_good ? *address : *address >> 1;
  }
  void read_channel() {
    if (!applies("channel", type_.needs_channel)) return;
    const xml::Attribute* attribute = tag_.attribute("channel");
    const bool has_place = device_.segment.has_value() && !bus_is_wrong_;
    const std::uint32_t count = has_place ? channel_count(reading_, *device_.segment) : 0;
    if (attribute == nullptr) {
      if (count == 1) device_.channel = 0;
      return;  // more: report_missing_places()
    }
    const auto channel = read_quantity(tag_, "channel", units::parse_bare, diagnostics_);
    if (!channel) return;
    const std::uint32_t least = type_.channel_min.value_or(0);
    const std::uint32_t most = std::min(type_.channel_max.value_or(UINT32_MAX), count > 0 ? count - 1 : UINT32_MAX);
    if (*channel >= least && *channel <= most) {
      device_.channel = *channel;
      return;
    }
    at_value(diagnostics_, code::channel_range, *attribute,
             fmt::format("bus '{}' has no channel {}", value_of(tag_, "bus"), *channel))
        .hint(least == most ? fmt::format("its only channel is {}", most)
                            : fmt::format("its channels are {} to {}", least, most));
  }
  void read_id() {
    if (!applies("id", type_.needs_id)) return;
    const xml::Attribute* attribute = tag_.attribute("id");
    const std::uint32_t least = type_.id_min.value_or(0);
    const std::uint32_t most = type_.id_max.value_or(UINT32_MAX);
    if (attribute == nullptr) return;  // report_missing_places()
    const auto id = read_quantity(tag_, "id", units::parse_bare, diagnostics_);
    if (!id) return;
    if (*id >= least && *id <= most) {
      device_.id = *id;
      return;
    }
    at_value(diagnostics_, code::id_range, *attribute, fmt::format("'{}' cannot have the id {}", type_.name, *id))
        .hint(fmt::format("its ids are {} to {}", least, most));
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  Device& device_;
  const DeviceType& type_;
  const xml::Node& tag_;
  bool bus_is_wrong_;
};

/// Something that sits somewhere, for messages.
struct Occupant {
  std::string what;  ///< `device 'baro_1'`
  const xml::Node* tag;
};

/// An error at the attribute of the tag, or at the tag when the value was a default.
Diagnostic& at_place(Diagnostics& diagnostics, Code code, const Occupant& occupant, std::string_view attribute,
                     std::string message) {
  const xml::Attribute* found = occupant.tag->attribute(attribute);
  return found != nullptr ? at_value(diagnostics, code, *found, std::move(message))
                          : at_tag(diagnostics, code, *occupant.tag, std::move(message));
}

/// Addresses on one physical bus. A mux channel is a segment of its own, but what sits on the bus itself is seen
/// through every channel.
class AddressTable {
 public:
  explicit AddressTable(Reading& reading) : reading_(reading) {}

  void add(SegmentId segment_index, std::uint32_t address, const Occupant& occupant) {
    const Segment& segment = reading_.robot.segments[segment_index];
    if (segment.bus == kNoBus) return;
    const bool is_upstream = segment.kind == Segment::Kind::bus;
    for (const Entry& entry : entries_) {
      const bool same_bus = entry.bus == segment.bus && entry.address == address;
      if (!same_bus || (!is_upstream && !entry.is_upstream && entry.segment != segment_index)) continue;
      report(occupant, entry, address, segment, entry.segment == segment_index);
      break;
    }
    entries_.push_back({segment.bus, segment_index, address, is_upstream, occupant});
  }

 private:
  struct Entry {
    BusId bus;
    SegmentId segment;
    std::uint32_t address;
    bool is_upstream;
    Occupant occupant;
  };
  void report(const Occupant& occupant, const Entry& other, std::uint32_t address, const Segment& segment,
              bool same_segment) {
    auto& finding =
        at_place(reading_.diagnostics, code::address_conflict, occupant, "address",
                 fmt::format("{} and {} both answer to 0x{:02x}", occupant.what, other.occupant.what, address));
    finding.note(fmt::format("{} is declared here", other.occupant.what), other.occupant.tag->at);
    const Name& bus = reading_.robot.buses[segment.bus].name;
    finding.note(same_segment ? fmt::format("both sit on '{}'", segment.name.text)
                              : fmt::format("what sits on '{}' itself is seen through every mux channel", bus.text));
    for (const Occupant* each : {&occupant, &other.occupant}) {
      if (!each->tag->is_element("expander")) continue;
      finding.hint(fmt::format("set another address at {}, here and at the pins of the part", each->what));
      return;
    }
    if (!same_segment) {
      const bool is_upstream = segment.kind == Segment::Kind::bus;
      finding.hint(to_a_channel(is_upstream ? occupant.what : other.occupant.what,
                                is_upstream ? reading_.robot.segments[other.segment] : segment));
      return;
    }
    if (segment.name.text != bus.text) return void(finding.hint("put one on another channel, or on another bus"));
    finding.hint(behind_a_mux(bus.text));
    const Bus& physical = reading_.robot.buses[segment.bus];
    const std::string elsewhere =
        another_bus(reading_.robot.board, used_ports(reading_.robot), physical.kind, physical.rate);
    if (!elsewhere.empty()) finding.hint("or put one on a bus of its own: " + elsewhere);
  }

  static std::string behind_a_mux(const std::string& bus) {
    return fmt::format(
        "put both behind a multiplexer, each on a channel of its own: <expander name=\"mux\" model=\"tca9548a\" "
        "bus=\"{}\" address=\"0x70\"><channel index=\"0\" name=\"mux_0\"/><channel index=\"1\" "
        "name=\"mux_1\"/></expander>, then bus=\"mux_0\" at the one and bus=\"mux_1\" at the other",
        bus);
  }

  /// How what sits on the bus itself gets a channel of the multiplexer that `channel` is of.
  [[nodiscard]] std::string to_a_channel(const std::string& what, const Segment& channel) const {
    if (!channel.expander) return "put one of them on another bus";
    const Expander& mux = reading_.robot.expanders[*channel.expander];
    std::uint32_t index = 0;
    const auto taken = [&] {
      return std::any_of(mux.channels.begin(), mux.channels.end(), [&](const auto& c) { return c.index == index; });
    };
    while (taken()) ++index;
    constexpr std::uint32_t kChannels = 8;
    if (index >= kChannels)
      return fmt::format("put {} on another bus: all channels of '{}' are named", what, mux.name.text);
    return fmt::format(
        "put {0} behind a channel of its own: <channel index=\"{1}\" name=\"{2}_{1}\"/> in '{2}', and "
        "bus=\"{2}_{1}\"",
        what, index, mux.name.text);
  }

  Reading& reading_;
  std::vector<Entry> entries_;
};

Occupant describe(const Reading& reading, DeviceId device) {
  return {fmt::format("device '{}'", reading.robot.devices[device].name.text), &reading.device_tag(device)};
}

bool expander_is_placed(const Reading& reading, ExpanderId index) {
  return reading.robot.expanders[index].segment != kNoSegment;
}

/// Whether the chain from the segment down to the physical bus is known.
bool is_attached(const Reading& reading, const Segment& segment) {
  if (!segment.expander) return true;
  if (!expander_is_placed(reading, *segment.expander)) return false;
  const Segment& below = reading.robot.segments[reading.robot.expanders[*segment.expander].segment];
  return !below.expander || expander_is_placed(reading, *below.expander);
}

void check_addresses(Reading& reading) {
  AddressTable table(reading);
  for (const ExpanderId i : reading.robot.expanders.ids()) {
    const Expander& expander = reading.robot.expanders[i];
    if (expander.address == 0 || !expander_is_placed(reading, i) ||
        !is_attached(reading, reading.robot.segments[expander.segment]))
      continue;
    table.add(expander.segment, expander.address,
              {fmt::format("expander '{}'", expander.name.text), reading.tags.expanders[i]});
  }
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (!device.segment || !device.address || reading.robot.segments[*device.segment].bus_kind != BusKind::i2c)
      continue;
    if (is_attached(reading, reading.robot.segments[*device.segment]))
      table.add(*device.segment, *device.address, describe(reading, i));
  }
}

/// Pulse outputs or chip selects of a segment; 0: it has none, or they are not known.
std::uint32_t use_channels(const Reading& reading, SegmentId segment) {
  const BusKind kind = reading.robot.segments[segment].bus_kind;
  return kind == BusKind::pwm || kind == BusKind::spi ? channel_count(reading, segment) : 0;
}

std::string example_channel(const Reading& reading, SegmentId segment, std::uint32_t count) {
  const std::vector<std::uint32_t> free = free_channels(reading, segment, count);
  return free.empty() ? "none is free: name another bus" : fmt::format("add for example channel=\"{}\"", free.front());
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

/// A serial line carries one device; `use` counts.
void check_exclusive(Reading& reading) {
  std::map<SegmentId, Occupant> users;
  const auto take = [&](SegmentId segment, const Occupant& occupant) {
    if (reading.robot.segments[segment].bus_kind != BusKind::uart) return;
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

/// What could be written instead of a channel that is taken.
std::string other_channels(const Reading& reading, SegmentId segment) {
  constexpr std::size_t kMost = 8;
  const std::vector<std::uint32_t> free = free_channels(reading, segment, channel_count(reading, segment));
  std::string list;
  for (std::size_t i = 0; i < free.size() && i < kMost; ++i) list += (i > 0 ? ", " : "") + std::to_string(free[i]);
  if (list.empty()) return "no channel of it is free: put one of them on another bus";
  return fmt::format("channels that are free here: {}{}", list, free.size() > kMost ? ", ..." : "");
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
    if (reading.robot.segments[segment].bus_kind == BusKind::pwm) finding.hint(other_channels(reading, segment));
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

/// A device with an id on a bus.
struct IdUser {
  BusId bus;
  std::uint32_t id;
  const DeviceType* type;
};

bool receive_alike(const DeviceType& a, const DeviceType& b) { return a.receives_base && b.receives_base; }

/// The same id of one type, or frames of different types that would carry one identifier.
bool clash(const IdUser& a, const IdUser& b) {
  if (a.bus != b.bus) return false;
  if (receive_alike(*a.type, *b.type)) return *a.type->receives_base + a.id == *b.type->receives_base + b.id;
  return a.type == b.type && a.id == b.id;
}

std::optional<IdUser> id_user(const Reading& reading, const Device& device) {
  if (!device.segment || !device.id || device.type == nullptr) return {};
  return IdUser{reading.robot.segments[*device.segment].bus, *device.id, device.type};
}

/// `: 'can_b'`, buses of the same kind; where there are none, one to add; empty where nothing can be added.
std::string another_bus_for(const Reading& reading, const Segment& segment) {
  const Bus& bus = reading.robot.buses[segment.bus];
  std::string list;
  std::vector<std::string> used;
  for (const BusId i : reading.robot.buses.ids()) {
    const Bus& other = reading.robot.buses[i];
    used.emplace_back(value_of(*reading.tags.buses[i], "port"));
    if (i == segment.bus || other.kind != bus.kind || !reading.buses[i].kind_is_known) continue;
    list += (list.empty() ? ": '" : ", '") + other.name.text + "'";
  }
  if (!list.empty()) return list;
  const std::string fresh = another_bus(reading.robot.board, used, bus.kind, bus.rate);
  return fresh.empty() ? fresh : ": " + fresh;
}

/// Ids that earlier findings offer first, as identifiers on the wire or ids of a type: not to be offered again.
using Promised = std::vector<IdUser>;

/// What could be written instead; in the part it has to be set as well.
void offer_ids(const Reading& reading, const Device& device, Promised& promised, Diagnostic& finding) {
  const Segment& segment = reading.robot.segments[*device.segment];
  std::string list;
  for (const std::uint32_t id : free_ids(reading, *device.type, *device.segment)) {
    const IdUser user{segment.bus, id, device.type};
    if (std::any_of(promised.begin(), promised.end(), [&](const IdUser& other) { return clash(user, other); }))
      continue;
    if (list.empty()) promised.push_back(user);
    list += (list.empty() ? "" : ", ") + std::to_string(id);
  }
  if (!list.empty()) {
    finding.hint(fmt::format("ids of '{}' that are free on '{}': {}; set the same in the part", device.type->name,
                             segment.name.text, list));
  }
  const std::string other = another_bus_for(reading, segment);
  if (other.empty() && !list.empty()) return;
  finding.hint(
      (list.empty() ? "no id is free here: put one of them on another bus" : "or put one of them on another bus") +
      other);
}

void report_ids(Reading& reading, DeviceId index, DeviceId first, Promised& promised) {
  const Device& device = reading.robot.devices[index];
  const Device& other = reading.robot.devices[first];
  const Name& bus = reading.robot.buses[reading.robot.segments[*device.segment].bus].name;
  auto& finding =
      at_place(reading.diagnostics, code::id_conflict, describe(reading, index), "id",
               fmt::format("device '{}' (id {}) and device '{}' (id {}) use the same CAN identifier on bus '{}'",
                           device.name.text, *device.id, other.name.text, *other.id, bus.text));
  if (receive_alike(*device.type, *other.type))
    finding.note(
        fmt::format("both send frames with the identifier 0x{:03X}", *device.type->receives_base + *device.id));
  finding.note(fmt::format("device '{}' is declared here", other.name.text), other.at);
  offer_ids(reading, device, promised, finding);
}

void check_ids(Reading& reading) {
  Promised promised;
  for (const DeviceId i : reading.robot.devices.ids()) {
    const auto self = id_user(reading, reading.robot.devices[i]);
    if (!self) continue;
    for (const DeviceId first : reading.robot.devices.ids()) {
      if (first == i) break;
      const auto other = id_user(reading, reading.robot.devices[first]);
      if (!other || !clash(*self, *other)) continue;
      report_ids(reading, i, first, promised);
      break;
    }
  }
}

/// Devices that fill one frame have to run in one bucket: the frame is sent once per period.
void check_shared_frames(Reading& reading) {
  struct Filler {
    std::int64_t period_ns;
    Occupant occupant;
  };
  std::map<std::pair<BusId, std::uint32_t>, Filler> first;
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (!device.segment || !device.id || reading.devices[i].period_is_wrong || device.period_ns == 0) continue;
    for (const SharedFrame& frame : device.type->shared_frames()) {
      if (*device.id < frame.id_min || *device.id > frame.id_max) continue;
      const auto key = std::make_pair(reading.robot.segments[*device.segment].bus, frame.identifier);
      const auto [known, is_fresh] = first.emplace(key, Filler{device.period_ns, describe(reading, i)});
      if (is_fresh || known->second.period_ns == device.period_ns) continue;
      at_place(reading.diagnostics, code::frame_split, describe(reading, i), "period",
               fmt::format("device '{}' shares a CAN frame with {} but not its period", device.name.text,
                           known->second.occupant.what))
          .note(fmt::format("frame 0x{:03X} carries the commands of both; one runs every {}, the other every {}",
                            frame.identifier, units::format_duration(known->second.period_ns),
                            units::format_duration(device.period_ns)))
          .note(fmt::format("{} is declared here", known->second.occupant.what), known->second.occupant.tag->at)
          .hint("give both one period, or one of them an id of another frame");
    }
  }
}

}  // namespace

const xml::Node& use_tag(const Reading& reading, DeviceId device, const Use& use) {
  const xml::Node& tag = reading.device_tag(device);
  for (const xml::Node& child : tag.children) {
    if (child.is_element("use") && child.at.line == use.at.line && child.at.column == use.at.column) return child;
  }
  return tag;
}

std::uint32_t channel_count(const Reading& reading, SegmentId index) {
  const Segment& segment = reading.robot.segments[index];
  if (segment.kind == Segment::Kind::pwm_expander) return reading.robot.expanders[*segment.expander].type->channels;
  const Board* board = reading.robot.board;
  if (segment.bus_kind == BusKind::gpio) return board != nullptr ? static_cast<std::uint32_t>(board->pins.size()) : 0;
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

std::vector<std::uint32_t> free_ids(const Reading& reading, const DeviceType& type, SegmentId segment) {
  constexpr std::uint32_t kMost = 16;
  const std::uint32_t least = type.id_min.value_or(0);
  std::vector<std::uint32_t> free;
  for (std::uint32_t id = least; id <= type.id_max.value_or(0) && id < least + kMost; ++id) {
    const IdUser wanted{reading.robot.segments[segment].bus, id, &type};
    const bool is_free = std::none_of(reading.robot.devices.begin(), reading.robot.devices.end(), [&](const Device& d) {
      const auto user = id_user(reading, d);
      return user && clash(wanted, *user);
    });
    if (is_free) free.push_back(id);
  }
  return free;
}

void resolve_places(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    if (reading.robot.devices[i].type != nullptr) PlaceReader(reading, i).read();
  }
  resolve_use_channels(reading);
  PlaceReader::Offered offered;
  for (const DeviceId i : reading.robot.devices.ids()) {
    if (reading.robot.devices[i].type != nullptr) PlaceReader(reading, i).report_missing_places(offered);
  }
  check_addresses(reading);
  check_exclusive(reading);
  check_channels(reading);
  check_ids(reading);
  check_shared_frames(reading);
}

}  // namespace finemote::gen
