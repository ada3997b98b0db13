// I2C addresses: what each device's is, and who answers to the same one. FM3061 to FM3063.
#include <fmt/format.h>

#include <algorithm>

#include "generator/descriptor/library.hpp"
#include "generator/model/address.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/places.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

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

  [[nodiscard]] std::string behind_a_mux(const std::string& bus) const {
    return fmt::format(
        "put both behind a multiplexer, each on a channel of its own: <expander name=\"mux\" model=\"{}\" "
        "bus=\"{}\" address=\"0x70\"><channel index=\"0\" name=\"mux_0\"/><channel index=\"1\" "
        "name=\"mux_1\"/></expander>, then bus=\"mux_0\" at the one and bus=\"mux_1\" at the other",
        suggested_mux(reading_.library, reading_.sources), bus);
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
    if (mux.type != nullptr && index >= mux.type->channels)
      return fmt::format("put {} on another bus: all channels of '{}' are named", what, mux.name.text);
    return fmt::format(
        "put {0} behind a channel of its own: <channel index=\"{1}\" name=\"{2}_{1}\"/> in '{2}', and "
        "bus=\"{2}_{1}\"",
        what, index, mux.name.text);
  }

  Reading& reading_;
  std::vector<Entry> entries_;
};

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

}  // namespace

void read_address(const Placing& at) {
  if (!at.applies("address", at.type.needs_address)) return;
  const xml::Attribute* attribute = at.tag.attribute("address");
  if (attribute == nullptr) {
    at.device.address = at.type.default_address;
    if (!at.device.address)
      at.report_missing("address",
                        at.type.addresses.empty() ? "0x76" : fmt::format("0x{:02x}", at.type.addresses.front()));
    return;
  }
  const auto address = read_quantity(at.tag, "address", units::parse_bare, at.diagnostics());
  if (!address) return;
  const bool is_good = check_address(at.diagnostics(), *attribute, *address, at.type.addresses, at.type.name);
  // a wrong address that was surely meant as another one takes part in the search for conflicts as that
  if (is_good || is_8bit_address(*address, at.type.addresses)) at.device.address = is_good ? *address : *address >> 1;
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

}  // namespace finemote::gen
