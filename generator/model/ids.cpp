// Ids on a bus: which one each device has, whose frames collide, and who fills one together. FM3067 to FM3069.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/model/attributes.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/places.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

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

}  // namespace

void read_id(const Placing& at) {
  if (!at.applies("id", at.type.needs_id)) return;
  const xml::Attribute* attribute = at.tag.attribute("id");
  const std::uint32_t least = at.type.id_min.value_or(0);
  const std::uint32_t most = at.type.id_max.value_or(UINT32_MAX);
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

}  // namespace finemote::gen
