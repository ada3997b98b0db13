// The <bus> elements: kinds and ports. FM3011 to FM3014, FM3018, FM3010 for a port that is missing.
#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/bus_offers.hpp"
#include "generator/model/bus_rate.hpp"
#include "generator/model/names.hpp"
#include "generator/model/pins.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using PortNeed = BusType::PortNeed;

PortNeed port_need(BusKind kind) { return bus_type(kind).port_need; }

/// Finds the port a bus names and says what is wrong with the name.
class PortFinder {
 public:
  PortFinder(Reading& reading, const xml::Node& tag, std::optional<BusKind> kind)
      : reading_(reading), tag_(tag), kind_(kind) {}

  const Port* find() {
    const xml::Attribute* name = tag_.attribute("port");
    if (kind_ && port_need(*kind_) == PortNeed::never) return refuse(name);
    const Board* board = reading_.robot.board;
    const bool has_ports = board == nullptr || !kind_ || !ports_for(*board, kind_).empty();
    if (name == nullptr) {
      if (kind_ && (has_ports || port_need(*kind_) == PortNeed::always)) report_missing();
      return nullptr;
    }
    return board == nullptr ? nullptr : look_up(*board, *name);
  }

 private:
  const Port* refuse(const xml::Attribute* name) {
    if (name != nullptr) {
      at_value(reading_.diagnostics, code::attribute_unused, *name,
               fmt::format("a {} bus has no port", bus_kind_name(*kind_)))
          .hint("remove port=\"" + name->value + "\"");
    }
    return nullptr;
  }
  void report_missing() {
    if (reading_.tags.is_misspelt(tag_, "port")) return;
    const std::string example = example_port(reading_, kind_);
    at_tag(reading_.diagnostics, code::attribute_missing, tag_,
           fmt::format("bus '{}' has no 'port'", value_of(tag_, "name")))
        .hint(fmt::format("add for example port=\"{}\"", example.empty() ? "usart1" : example));
  }
  const Port* look_up(const Board& board, const xml::Attribute& name) {
    const Port* port = board.port(name.value);
    if (port == nullptr) {
      if (!is_label(board, name)) report_unknown(board, name);
      return nullptr;
    }
    if (!kind_ || port->serves(*kind_)) return port;
    auto& finding =
        at_value(reading_.diagnostics, code::port_kind, name,
                 fmt::format("port '{}' cannot serve a bus of type '{}'", port->name, bus_kind_name(*kind_)));
    finding.note(fmt::format("it can serve: {}", fmt::join(bus_kind_names(port->kinds), ", ")));
    const std::vector<std::string> able = ports_for(board, kind_);
    if (!able.empty()) finding.hint(did_you_mean(port->name, able));
    return nullptr;
  }
  /// A name printed on the board: the message names both.
  bool is_label(const Board& board, const xml::Attribute& name) {
    const std::string label = fold_case(name.value);
    for (const Port& port : board.ports) {
      if (std::find(port.silkscreen.begin(), port.silkscreen.end(), label) == port.silkscreen.end()) continue;
      at_value(reading_.diagnostics, code::silkscreen_port, name,
               fmt::format("'{}' is a label of the board, not a port", name.value))
          .note(fmt::format("the port behind '{}' is '{}': {}", name.value, port.name, port.connector))
          .hint(instead_of_label(port));
      return true;
    }
    return false;
  }
  /// The port behind a label, unless it cannot serve this bus or another one names it already.
  std::string instead_of_label(const Port& port) {
    const auto& tags = reading_.tags.buses;
    const auto user = std::find_if(tags.begin(), tags.end(), [&](const xml::Node* tag) {
      return tag != &tag_ && value_of(*tag, "port") == port.name;
    });
    const bool is_free = user == tags.end();
    if (!kind_ || (is_free && port.serves(*kind_))) return fmt::format("write port=\"{}\"", port.name);
    const std::string why = is_free ? fmt::format("'{}' cannot serve this bus", port.name)
                                    : fmt::format("bus '{}' uses '{}'", value_of(**user, "name"), port.name);
    const auto others = suitable_ports(reading_, tag_, *kind_);
    if (others.empty()) return fmt::format("{}, and no other port for {} is free", why, bus_kind_name(*kind_));
    return fmt::format("write port=\"{}\", which is free: {}", others.front(), why);
  }
  void report_unknown(const Board& board, const xml::Attribute& name) {
    auto& finding = at_value(reading_.diagnostics, code::unknown_port, name,
                             fmt::format("board '{}' has no port '{}'", board.name, name.value));
    const auto fitting = unclaimed(reading_, ports_for(board, kind_));
    if (kind_ && port_need(*kind_) == PortNeed::where_there_is_one && fitting.empty()) {
      finding.note(fmt::format("no port of this board serves {}", bus_kind_name(*kind_)))
          .hint("remove the bus: a <use> names its pin itself");
      return;
    }
    const auto all = unclaimed(reading_, ports_for(board, {}));
    suggest(finding, name.value,
            nearest_names(name.value, fitting).empty() && !nearest_names(name.value, all).empty() ? all : fitting);
  }

  Reading& reading_;
  const xml::Node& tag_;
  std::optional<BusKind> kind_;
};

/// What a bus whose parts send through line drivers can be told. The param objects point at these specs.
const std::vector<ParamSpec>& direction_params() {
  static const std::vector<ParamSpec> specs = [] {
    ParamSpec direction;
    direction.name = "direction";
    direction.kind = ParamKind::text;
    direction.fallback = ParamValue(std::string());
    direction.summary = "pin that turns the line driver on";
    return std::vector<ParamSpec>{direction};
  }();
  return specs;
}

void read_driver_pin(Reading& reading, const xml::Node& tag, Bus& bus, const std::string& owner) {
  for (const xml::Node& child : tag.children) {
    if (!child.is_element("param") || value_of(child, "name") != "direction") continue;
    const TextAt text = element_text(child);
    const PlacedPin pin = find_pin(reading.robot.board, text.text, text.at, owner, {"output"}, reading.diagnostics);
    bus.driver_pin = pin.pin;
    bus.driver_named = pin.named;
    bus.driver_at = text.at;
    bus.driver_length = text.text.size();
    return;
  }
}

void read_bus(Reading& reading, const xml::Node& tag) {
  Bus bus;
  bus.name = make_name(value_of(tag, "name"));
  bus.at = tag.at;
  Reading::BusState state;
  const auto kind_name = read_choice(tag, "type", bus_kind_names(), reading.diagnostics);
  const auto kind = kind_name ? bus_kind(*kind_name) : std::nullopt;
  state.kind_is_known = kind.has_value();
  bus.kind = kind.value_or(BusKind{});
  state.port = PortFinder(reading, tag, kind).find();
  if (state.port != nullptr) bus.port = state.port->name;
  if (kind) read_rate(reading, tag, bus, state);
  bus.isr_wcet = read_duration_in(tag, "isr_wcet", "us", reading.diagnostics);
  bus.min_frame_bits = read_quantity(tag, "min_frame", units::parse_bits, reading.diagnostics);
  if (bus.min_frame_bits == 0) {
    at_value(reading.diagnostics, code::param_range, *tag.attribute("min_frame"),
             "min_frame: a frame has at least one bit")
        .hint("write for example min_frame=\"20bit\"");
  }
  const std::string owner = fmt::format("bus '{}'", bus.name.text);
  const bool has_direction = kind && bus_type(*kind).has_direction;
  bus.params = read_param_tags(reading, tag, has_direction ? direction_params() : std::vector<ParamSpec>{}, owner);
  if (has_direction) read_driver_pin(reading, tag, bus, owner);
  reading.robot.buses.push_back(std::move(bus));
  reading.buses.push_back(state);
}

}  // namespace

void read_buses(Reading& reading) {
  for (const xml::Node* tag : reading.tags.buses) read_bus(reading, *tag);
  for (const BusId i : reading.robot.buses.ids()) {
    const Bus& bus = reading.robot.buses[i];
    reading.robot.segments.push_back({Segment::Kind::bus, bus.name, bus.kind, i, {}, 0});
  }
}

}  // namespace finemote::gen
