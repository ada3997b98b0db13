// The <expander> elements: FM3011, FM3019, FM3020, FM3061, FM3062, FM3064, FM3065, FM3074, FM3018.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/address.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/names.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

class ExpanderReader {
 public:
  ExpanderReader(Reading& reading, const xml::Node& tag)
      : reading_(reading), diagnostics_(reading.diagnostics), tag_(tag) {}

  void read() {
    expander_.name = make_name(value_of(tag_, "name"));
    expander_.at = tag_.at;
    expander_.segment = kNoSegment;
    read_model();
    if (expander_.type != nullptr) {
      read_own_address();
      expander_.params =
          read_param_tags(reading_, tag_, expander_.type->params, fmt::format("expander '{}'", expander_.name.text));
    }
    read_channels();
    add_segments();
    reading_.robot.expanders.push_back(std::move(expander_));
  }

 private:
  void read_model() {
    const auto model = read_choice(tag_, "model", expander_type_names(reading_.library), diagnostics_);
    if (model) expander_.type = find_expander_type(reading_.library, *model, reading_.sources, diagnostics_);
  }
  void read_own_address() {
    const xml::Attribute* attribute = tag_.attribute("address");
    if (attribute == nullptr) return;
    const auto address = read_quantity(tag_, "address", units::parse_bare, diagnostics_);
    if (address && check_address(diagnostics_, *attribute, *address, expander_.type->addresses, expander_.type->name))
      expander_.address = *address;
  }
  void read_channels() {
    std::map<std::uint32_t, const xml::Node*> used;
    for (const xml::Node& child : tag_.children) {
      if (!child.is_element("channel")) continue;
      if (expander_.type != nullptr && !expander_.type->is_mux()) {
        at_tag(diagnostics_, code::attribute_unused, child,
               fmt::format("the channels of '{}' are not named", expander_.type->name))
            .hint(fmt::format("remove the <channel>; a device says bus=\"{}\" channel=\"0\"", expander_.name.text));
        continue;
      }
      read_channel(child, used);
    }
  }
  void read_channel(const xml::Node& child, std::map<std::uint32_t, const xml::Node*>& used) {
    Expander::Channel channel;
    channel.name = make_name(value_of(child, "name"));
    channel.at = child.at;
    const auto index = read_quantity(child, "index", units::parse_bare, diagnostics_);
    if (index) check_index(child, *index, used);
    channel.index = index.value_or(0);
    expander_.channels.push_back(std::move(channel));
  }
  void check_index(const xml::Node& child, std::uint32_t index, std::map<std::uint32_t, const xml::Node*>& used) {
    const xml::Attribute& attribute = *child.attribute("index");
    if (expander_.type != nullptr && index >= expander_.type->channels) {
      at_value(diagnostics_, code::channel_range, attribute,
               fmt::format("'{}' has no channel {}", expander_.type->name, index))
          .hint(fmt::format("its channels are 0 to {}", expander_.type->channels - 1));
      return;
    }
    const auto [first, is_fresh] = used.emplace(index, &child);
    if (is_fresh) return;
    at_value(diagnostics_, code::channel_twice, attribute,
             fmt::format("channel {} of expander '{}' is used twice", index, expander_.name.text))
        .note("the first use is here", first->second->at)
        .hint(free_indices());
  }
  /// Channels that no <channel> of the tag names.
  [[nodiscard]] std::string free_indices() const {
    std::string list;
    const std::uint32_t count = expander_.type != nullptr ? expander_.type->channels : 0;
    for (std::uint32_t index = 0; index < count; ++index) {
      const bool is_named = std::any_of(tag_.children.begin(), tag_.children.end(), [&](const xml::Node& child) {
        if (!child.is_element("channel")) return false;
        const auto named = units::parse_bare(value_of(child, "index"));
        return named && *named == index;
      });
      if (!is_named) list += (list.empty() ? "" : ", ") + std::to_string(index);
    }
    return list.empty() ? "all are used: add a second part at another address" : "channels that are free: " + list;
  }
  void add_segments() {
    auto& segments = reading_.robot.segments;
    const ExpanderId self = reading_.robot.expanders.next_id();
    if (expander_.type != nullptr && !expander_.type->is_mux()) {
      segments.push_back({Segment::Kind::pwm_expander, expander_.name, expander_.type->provides, kNoBus, self, 0});
    }
    for (const Expander::Channel& channel : expander_.channels) {
      segments.push_back(
          {Segment::Kind::mux_channel, channel.name, expander_bus_type().kind, kNoBus, self, channel.index});
    }
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  Expander expander_;
};

/// `<bus type="pca9685">`: how the part is written.
void report_misnamed(Reading& reading, const xml::Node& tag) {
  const xml::Attribute& type = *tag.attribute("type");
  const std::string model = fold_case(type.value);
  auto& finding = at_value(reading.diagnostics, code::bad_choice, type,
                           fmt::format("'{}' is a part on a bus that provides buses, not a type of <bus>", type.value));
  const ExpanderType* part = find_expander_type(reading.library, model, reading.sources, reading.diagnostics);
  if (part == nullptr) return;
  const auto given = [&](const char* name, const std::string& otherwise) {
    const std::string_view value = value_of(tag, name);
    return value.empty() ? otherwise : std::string(value);
  };
  std::string bus(expander_bus_type().name);
  for (const Bus& other : reading.robot.buses) {
    if (!bus_type(other.kind).carries_expanders) continue;
    bus = other.name.text;
    break;
  }
  const std::string name = given("name", part->is_mux() ? "mux" : "pwm");
  const std::string address = part->addresses.empty() ? "0x70" : fmt::format("0x{:02x}", part->addresses.front());
  const std::string start = fmt::format("<expander name=\"{}\" model=\"{}\" bus=\"{}\" address=\"{}\"", name, model,
                                        given("bus", bus), given("address", address));
  finding.hint(part->is_mux() ? fmt::format("write {}><channel index=\"0\" name=\"{}_0\"/></expander>", start, name)
                              : fmt::format("write {}/>", start));
}

/// Buses an expander can sit on: not what it provides itself, and for a mux no channel of another.
std::vector<std::string> buses_for(const Reading& reading, ExpanderId index) {
  const Expander& expander = reading.robot.expanders[index];
  const bool is_mux = expander.type == nullptr || expander.type->is_mux();
  std::vector<std::string> names;
  for (const Segment& segment : reading.robot.segments) {
    const bool is_behind = segment.kind != Segment::Kind::bus;
    if (!bus_type(segment.bus_kind).carries_expanders || (is_behind && (is_mux || segment.expander == index))) continue;
    names.push_back(segment.name.text);
  }
  return names;
}

/// Finds the bus an expander sits on; all names are known now, so it may stand further down.
void attach(Reading& reading, ExpanderId index) {
  Expander& expander = reading.robot.expanders[index];
  const xml::Attribute* bus = reading.tags.expanders[index]->attribute("bus");
  if (bus == nullptr) return;
  const auto segment = reading.segment_named(bus->value);
  if (!segment) {
    reading.report_unknown_bus(*bus, buses_for(reading, index));
    return;
  }
  const Segment& target = reading.robot.segments[*segment];
  if (reading.kind_is_known(target) && !bus_type(target.bus_kind).carries_expanders) {
    at_value(reading.diagnostics, code::bus_kind, *bus,
             fmt::format("expander '{}' needs an {} bus; '{}' is of type '{}'", expander.name.text,
                         expander_bus_type().name, bus->value, bus_kind_name(target.bus_kind)));
    return;
  }
  if (target.kind == Segment::Kind::mux_channel && expander.type != nullptr && expander.type->is_mux()) {
    at_value(reading.diagnostics, code::mux_nested, *bus,
             fmt::format("expander '{}' is a mux behind a mux", expander.name.text))
        .note(fmt::format("'{}' is a channel of expander '{}'", bus->value,
                          reading.robot.expanders[*target.expander].name.text))
        .hint("put it on the bus itself, with an address of its own");
    return;
  }
  expander.segment = *segment;
}

/// The physical bus of what an expander provides; a PWM expander may sit behind a mux. It stays kNoBus where the
/// expander sits on nothing: that was reported.
void find_physical_bus(Robot& robot, Segment& segment) {
  const Expander& expander = robot.expanders[*segment.expander];
  if (expander.segment == kNoSegment) return;
  const Segment& below = robot.segments[expander.segment];
  if (below.kind == Segment::Kind::bus) {
    segment.bus = below.bus;
  } else if (below.expander && robot.expanders[*below.expander].segment != kNoSegment) {
    segment.bus = robot.segments[robot.expanders[*below.expander].segment].bus;
  }
}

}  // namespace

void read_expanders(Reading& reading) {
  for (const xml::Node* tag : reading.tags.misnamed_expanders) report_misnamed(reading, *tag);
  for (const xml::Node* tag : reading.tags.expanders) ExpanderReader(reading, *tag).read();
  for (const ExpanderId i : reading.robot.expanders.ids()) attach(reading, i);
  for (Segment& segment : reading.robot.segments) {
    if (segment.expander) find_physical_bus(reading.robot, segment);
  }
}

}  // namespace finemote::gen
