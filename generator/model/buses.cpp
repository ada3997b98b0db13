// The <bus> elements: kinds, ports and rates. FM3011 to FM3014, FM3017, FM3018, FM3010 for what the kind asks for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/bus_offers.hpp"
#include "generator/model/names.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/pins.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

bool serves(const Port& port, BusKind kind) {
  return std::find(port.kinds.begin(), port.kinds.end(), kind) != port.kinds.end();
}

/// Ports that can serve the kind; all ports when the kind is not known.
std::vector<std::string> ports_for(const Board& board, std::optional<BusKind> kind) {
  std::vector<std::string> names;
  for (const Port& port : board.ports) {
    if (!kind || serves(port, *kind)) names.push_back(port.name);
  }
  return names;
}

/// Of these ports, those that no bus of the robot names, whether it stands before or after; all when none is left.
std::vector<std::string> unclaimed(const Reading& reading, const std::vector<std::string>& ports) {
  std::vector<std::string> names;
  for (const std::string& port : ports) {
    const auto& tags = reading.tags.buses;
    const auto claims = [&](const xml::Node* tag) { return value_of(*tag, "port") == port; };
    if (std::none_of(tags.begin(), tags.end(), claims)) names.push_back(port);
  }
  return names.empty() ? ports : names;
}

/// The port offered to a bus that names none; nothing where the board has none of the kind.
std::string example_port(const Reading& reading, std::optional<BusKind> kind) {
  const Board* board = reading.robot.board;
  const auto names = board != nullptr ? unclaimed(reading, ports_for(*board, kind)) : std::vector<std::string>{};
  return names.empty() ? std::string() : names.front();
}

/// Finds the port a bus names and says what is wrong with the name.
class PortFinder {
 public:
  PortFinder(Reading& reading, const xml::Node& tag, std::optional<BusKind> kind)
      : reading_(reading), tag_(tag), kind_(kind) {}

  const Port* find() {
    const xml::Attribute* name = tag_.attribute("port");
    if (kind_ == BusKind::virtual_bus) return refuse(name);
    const Board* board = reading_.robot.board;
    const bool has_ports = board == nullptr || !kind_ || !ports_for(*board, kind_).empty();
    if (name == nullptr) {
      if (kind_ && (has_ports || kind_ != BusKind::gpio)) report_missing();
      return nullptr;
    }
    return board == nullptr ? nullptr : look_up(*board, *name);
  }

 private:
  const Port* refuse(const xml::Attribute* name) {
    if (name != nullptr) {
      at_value(reading_.diagnostics, code::attribute_unused, *name, "a virtual bus has no port")
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
    if (!kind_ || serves(*port, *kind_)) return port;
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
    if (!kind_ || (is_free && serves(port, *kind_))) return fmt::format("write port=\"{}\"", port.name);
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
    if (kind_ == BusKind::gpio && fitting.empty()) {
      finding.note("no port of this board serves gpio").hint("remove the bus: a <use> names its pin itself");
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

/// The rate nearest to the one asked for that the port can make. UART: the clock over a whole divider >= 16 (RM0090
/// 30.3.4); I2C: over 3 times (above 100 kHz) or 2 times a whole divider (27.6.8); SPI: over 2 to 256, powers of two
/// (28.5.1); CAN: one of the port's list.
double nearest_rate(const Port& port, BusKind kind, double wanted) {
  if (!port.rates.empty()) {
    const auto nearer = [&](std::int64_t a, std::int64_t b) {
      return std::abs(static_cast<double>(a) - wanted) < std::abs(static_cast<double>(b) - wanted);
    };
    return static_cast<double>(*std::min_element(port.rates.begin(), port.rates.end(), nearer));
  }
  if (!port.clock_hz) return wanted;
  const auto clock = static_cast<double>(*port.clock_hz);
  if (kind == BusKind::spi) {
    double best = clock / 2;
    for (double divider = 4; divider <= 256; divider *= 2) {
      if (std::abs(clock / divider - wanted) < std::abs(best - wanted)) best = clock / divider;
    }
    return best;
  }
  if (kind == BusKind::i2c) {
    const double step = wanted > 100'000 ? 3 : 2;
    return clock / (step * std::max(1.0, std::round(clock / (step * wanted))));
  }
  return clock / std::max(16.0, std::round(clock / wanted));
}

/// How far what the port makes is from what is asked for, as a fraction of that.
double rate_error(const Port& port, BusKind kind, double wanted) {
  return std::abs(nearest_rate(port, kind, wanted) - wanted) / wanted;
}

void check_rate(Reading& reading, const xml::Attribute& attribute, const Port& port, const Bus& bus) {
  const auto report = [&]() -> Diagnostic& {
    return at_value(reading.diagnostics, code::rate_unreachable, attribute,
                    fmt::format("port '{}' cannot run at {}", port.name, attribute.value));
  };
  const std::int64_t least = port.min_rate.value_or(1);
  const std::int64_t most = port.max_rate.value_or(INT64_MAX);
  const std::int64_t parts = clock_of_parts(reading, bus.name.text);
  if (bus.rate < least || bus.rate > most) {
    const std::int64_t highest = std::max(least, std::min(most, parts));
    const std::string fastest =
        bus.kind == BusKind::spi ? fastest_clock(&port, bus.kind, highest) : rate_text(bus.kind, highest);
    report().hint(fmt::format("write a value from {} to {}", rate_text(bus.kind, least),
                              fastest.empty() ? rate_text(bus.kind, most) : fastest));
    return;
  }
  const auto wanted = static_cast<double>(bus.rate);
  const double made = nearest_rate(port, bus.kind, wanted);
  const double error = rate_error(port, bus.kind, wanted);
  if (error * 1e6 <= static_cast<double>(port.max_rate_error_ppm)) return;
  const std::string nearest = rate_text(bus.kind, std::llround(made));
  auto& finding = report();
  finding.note(fmt::format("the nearest rate is {}, {:.1f} % away; {:.1f} % is the limit", nearest, error * 100,
                           static_cast<double>(port.max_rate_error_ppm) / 1e4));
  if (made > static_cast<double>(parts)) {
    const std::string clock = fastest_clock(&port, bus.kind, parts);
    finding.hint(clock.empty()
                     ? "no clock of this port suits all devices on it: choose another port"
                     : fmt::format("write {}=\"{}\", the fastest for the devices on it", attribute.name, clock));
    return;
  }
  const bool has_slower = bus.kind == BusKind::spi && made > wanted;
  finding.hint(has_slower ? fmt::format("write {}=\"{}\", or the next slower one, \"{}\"", attribute.name, nearest,
                                        rate_text(bus.kind, std::llround(made / 2)))
                          : fmt::format("write {}=\"{}\"", attribute.name, nearest));
}

/// Whether the port makes the rate, nearly enough.
bool is_made(const Port& port, BusKind kind, std::int64_t rate) {
  if (rate < port.min_rate.value_or(1) || rate > port.max_rate.value_or(INT64_MAX)) return false;
  return rate_error(port, kind, static_cast<double>(rate)) * 1e6 <= static_cast<double>(port.max_rate_error_ppm);
}

/// A baud rate that every device on the bus can do and the port makes; the usual one when none is.
std::string example_baud(const Bus& bus, const Port* port, const std::vector<const DeviceType*>& types) {
  constexpr std::int64_t kUsualBaud = 115200;
  std::vector<std::int64_t> candidates{kUsualBaud};
  for (const DeviceType* type : types) candidates.insert(candidates.end(), type->rates.begin(), type->rates.end());
  const auto suits = [&](std::int64_t rate) {
    return (port == nullptr || is_made(*port, bus.kind, rate)) &&
           std::all_of(types.begin(), types.end(), [&](const DeviceType* type) {
             return type->rates.empty() || std::find(type->rates.begin(), type->rates.end(), rate) != type->rates.end();
           });
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), suits);
  return rate_text(bus.kind, found == candidates.end() ? kUsualBaud : *found);
}

/// A rate that the devices on the bus can do and the port makes, as the bus would write it; empty when there is none.
/// Without a port, one of the port that is offered for it.
std::string example_rate(Reading& reading, const Bus& bus, const Port* port) {
  constexpr std::int64_t kUsualClock = 5'250'000;
  const std::vector<const DeviceType*> types = types_on(reading, bus.name.text);
  const std::string offered = port == nullptr ? example_port(reading, bus.kind) : std::string();
  if (!offered.empty()) port = reading.robot.board->port(offered);
  if (bus.kind != BusKind::spi) return example_baud(bus, port, types);
  return fastest_clock(port, bus.kind, std::min(kUsualClock, clock_of_parts(reading, bus.name.text)));
}

/// The rate of kinds that run at one usual speed may be left out: the fastest the port makes.
bool has_usual_rate(BusKind kind) { return kind == BusKind::i2c || kind == BusKind::can; }

/// The unit that a rate without one was probably meant in: the port can run at it.
units::Fault with_meant_rate(units::Fault fault, std::string_view text, BusKind kind, const Port* port,
                             units::Result<std::int64_t> (*parse)(std::string_view)) {
  constexpr double kSlowestClock = 1000, kSlowestBits = 300;  // slower than anybody means
  const bool is_clock = rate_attribute(kind) == "clock";
  const double least = port != nullptr && port->min_rate ? static_cast<double>(*port->min_rate)
                       : is_clock                        ? kSlowestClock
                                                         : kSlowestBits;
  const double most = static_cast<double>(port != nullptr ? port->max_rate.value_or(INT64_MAX) : INT64_MAX);
  if (is_clock) return units::with_meant_unit(std::move(fault), text, {"Hz", "kHz", "MHz"}, parse, least, most);
  const std::string_view base = kind == BusKind::can ? "bit/s" : "baud";
  return units::with_meant_unit(std::move(fault), text, {base, "kbit/s", "Mbit/s"}, parse, least, most);
}

void read_rate(Reading& reading, const xml::Node& tag, Bus& bus, Reading::BusState& state) {
  const std::string_view wanted = rate_attribute(bus.kind);
  for (const std::string_view name :
       {std::string_view("baud"), std::string_view("clock"), std::string_view("bitrate")}) {
    const xml::Attribute* attribute = tag.attribute(name);
    if (attribute == nullptr || name == wanted) continue;
    auto& finding =
        reading.diagnostics.error(code::attribute_unused, attribute->at,
                                  fmt::format("a bus of type '{}' has no '{}'", bus_kind_name(bus.kind), name));
    finding.underline(name.size());
    finding.hint(wanted.empty() ? fmt::format("remove {}=\"{}\"", name, attribute->value)
                                : fmt::format("its rate is written {}=\"...\"", wanted));
    if (!wanted.empty() && tag.attribute(wanted) == nullptr) return;  // the rate is there, under another name
  }
  if (wanted.empty()) return;
  const xml::Attribute* attribute = tag.attribute(wanted);
  if (attribute == nullptr) {
    if (reading.tags.is_misspelt(tag, wanted)) return;
    const bool has_default = has_usual_rate(bus.kind);
    if (has_default && state.port != nullptr) {
      bus.rate = state.port->max_rate.value_or(0);
      state.rate_is_known = true;
    } else if (!has_default) {
      const std::string example = example_rate(reading, bus, state.port);
      at_tag(reading.diagnostics, code::attribute_missing, tag,
             fmt::format("bus '{}' has no '{}'", bus.name.text, wanted))
          .hint(example.empty() ? fmt::format("no {} of this port suits all devices on it: choose another port", wanted)
                                : fmt::format("add for example {}=\"{}\"", wanted, example));
    }
    return;
  }
  const auto parse = wanted == "clock" ? units::parse_frequency : units::parse_bitrate;
  const auto rate = parse(attribute->value);
  if (!rate) {
    const units::Fault fault = with_meant_rate(rate.fault(), attribute->value, bus.kind, state.port, parse);
    auto& finding = at_value(reading.diagnostics, fault.code, *attribute, std::string(wanted) + ": " + fault.message);
    if (!fault.hint.empty()) finding.hint(fault.hint);
    return;
  }
  if (*rate == 0) {
    at_value(reading.diagnostics, code::rate_unreachable, *attribute, fmt::format("'{}' of a bus is zero", wanted));
    return;
  }
  bus.rate = *rate;
  state.rate_is_known = true;
  if (state.port != nullptr) check_rate(reading, *attribute, *state.port, bus);
}

/// What an RS-485 bus can be told. The param objects point at these specs.
const std::vector<ParamSpec>& rs485_params() {
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
  bus.kind = kind.value_or(BusKind::uart);
  state.port = PortFinder(reading, tag, kind).find();
  if (state.port != nullptr) bus.port = state.port->name;
  if (kind) read_rate(reading, tag, bus, state);
  bus.isr_wcet_ns = read_duration_in(tag, "isr_wcet", "us", reading.diagnostics);
  bus.min_frame_bits = read_quantity(tag, "min_frame", units::parse_bits, reading.diagnostics);
  if (bus.min_frame_bits == 0) {
    at_value(reading.diagnostics, code::param_range, *tag.attribute("min_frame"),
             "min_frame: a frame has at least one bit")
        .hint("write for example min_frame=\"20bit\"");
  }
  const std::string owner = fmt::format("bus '{}'", bus.name.text);
  const bool is_rs485 = kind == BusKind::rs485;
  bus.params = read_param_tags(reading, tag, is_rs485 ? rs485_params() : std::vector<ParamSpec>{}, owner);
  if (is_rs485) read_driver_pin(reading, tag, bus, owner);
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
