// Ids on a bus: which one each device has, whose frames collide, and who fills one together. FM3067 to FM3069.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/bus/bus_type.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/places.hpp"
#include "generator/model/shared_frame.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// A device on a bus for ids. One whose type has none sends the same identifiers always.
struct IdUser {
  BusId bus;
  std::optional<std::uint32_t> id;
  const DeviceType* type;

  /// What its frames are told by.
  [[nodiscard]] std::uint32_t number() const { return id.value_or(0); }
  [[nodiscard]] std::vector<IdentifierRange> received() const { return type->received(number()); }
};

/// The lowest identifier that frames of both carry.
std::optional<std::uint64_t> common_identifier(const IdUser& a, const IdUser& b) {
  std::optional<std::uint64_t> lowest;
  for (const IdentifierRange& mine : a.received()) {
    for (const IdentifierRange& other : b.received()) {
      const auto common = finemote::gen::common_identifier(mine, other);
      if (common && (!lowest || *common < *lowest)) lowest = common;
    }
  }
  return lowest;
}

/// The frame in which both would fill the same bytes.
std::optional<std::uint32_t> common_bytes(const IdUser& a, const IdUser& b) {
  const auto mine = a.type->shared_frame(a.number()), other = b.type->shared_frame(b.number());
  if (!mine || !other || mine->identifier != other->identifier) return {};
  const std::uint64_t at = mine->offset(a.number()), other_at = other->offset(b.number());
  if (at + mine->width <= other_at || other_at + other->width <= at) return {};
  return mine->identifier;
}

/// The same id of one type, frames that would carry one identifier, or the same bytes of a frame.
bool clash(const IdUser& a, const IdUser& b) {
  if (a.bus != b.bus) return false;
  return common_identifier(a, b) || common_bytes(a, b) || (a.id && a.type == b.type && a.id == b.id);
}

std::optional<IdUser> id_user(const Reading& reading, const Device& device) {
  if (!device.segment || device.type == nullptr || (device.type->needs_id && !device.id)) return {};
  const BusId bus = reading.robot.segments[*device.segment].bus;
  const bool has_identifiers = bus != kNoBus && bus_type(reading.robot.buses[bus].kind).slot_class.takes_identifiers;
  if (!device.id && !has_identifiers) return {};
  return IdUser{bus, device.id, device.type};
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
  const auto free = device.id ? free_ids(reading, *device.type, *device.segment) : std::vector<std::uint32_t>();
  for (const std::uint32_t id : free) {
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
  finding.hint((list.empty() ? (device.id ? "no id is free here: put one of them on another bus"
                                          : "put one of them on another bus")
                             : "or put one of them on another bus") +
               other);
}

void report_ids(Reading& reading, DeviceId index, DeviceId first, Promised& promised) {
  const Device& device = reading.robot.devices[index];
  const Device& other = reading.robot.devices[first];
  const Name& bus = reading.robot.buses[reading.robot.segments[*device.segment].bus].name;
  const auto with_id = [](const Device& each) {
    return fmt::format("device '{}'", each.name.text) + (each.id ? fmt::format(" (id {})", *each.id) : "");
  };
  auto& finding = at_place(
      reading.diagnostics, code::id_conflict, describe(reading, index), device.id ? "id" : "bus",
      fmt::format("{} and {} use the same CAN identifier on bus '{}'", with_id(device), with_id(other), bus.text));
  const IdUser self = *id_user(reading, device), first_user = *id_user(reading, other);
  if (const auto identifier = common_identifier(self, first_user))
    finding.note(fmt::format("both send frames with the identifier 0x{:03X}", *identifier));
  else if (const auto frame = common_bytes(self, first_user))
    finding.note(fmt::format("both fill the same bytes of frame 0x{:03X}", *frame));
  finding.note(fmt::format("device '{}' is declared here", other.name.text), other.at);
  offer_ids(reading, device, promised, finding);
}

}  // namespace

void read_id(const Placing& at) {
  if (!at.applies("id", at.type.needs_id)) return;
  const xml::Attribute* attribute = at.tag.attribute("id");
  const std::uint32_t least = at.type.id_min.value_or(0);
  const std::uint32_t most = at.type.id_max.value_or(kHighestId);
  if (attribute == nullptr) return;  // report_missing_places()
  const auto id = read_quantity(at.tag, "id", units::parse_bare, at.diagnostics());
  if (!id) return;
  if (*id >= least && *id <= most) {
    at.device.id = *id;
    return;
  }
  at_value(at.diagnostics(), code::id_range, *attribute, fmt::format("'{}' cannot have the id {}", at.type.name, *id))
      .hint(fmt::format("its ids are {} to {}", least, most));
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
    Duration period;
    bool has_id;
    Occupant occupant;
  };
  std::map<std::pair<BusId, std::uint32_t>, Filler> first;
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    const auto frame = shared_frame_of(device);
    if (!frame || reading.devices[i].period_is_wrong || device.period == Duration::zero()) continue;
    const auto key = std::make_pair(reading.robot.segments[*device.segment].bus, frame->identifier);
    const auto [known, is_fresh] =
        first.emplace(key, Filler{device.period, device.id.has_value(), describe(reading, i)});
    if (is_fresh || known->second.period == device.period) continue;
    at_place(reading.diagnostics, code::frame_split, describe(reading, i), "period",
             fmt::format("device '{}' shares a CAN frame with {} but not its period", device.name.text,
                         known->second.occupant.what))
        .note(fmt::format("frame 0x{:03X} carries the commands of both; one runs every {}, the other every {}",
                          frame->identifier, units::format_duration(known->second.period),
                          units::format_duration(device.period)))
        .note(fmt::format("{} is declared here", known->second.occupant.what), known->second.occupant.tag->at)
        .hint(device.id || known->second.has_id ? "give both one period, or one of them an id of another frame"
                                                : "give both one period, or put one of them on another bus");
  }
}

}  // namespace finemote::gen
