#include "generator/model/bus_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/bus/bus_type.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/bus_offers.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/port_rates.hpp"

namespace finemote::gen {
namespace {

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
        has_few_rates(port, bus.kind) ? fastest_clock(&port, bus.kind, highest) : rate_text(bus.kind, highest);
    report().hint(fmt::format("write a value from {} to {}", rate_text(bus.kind, least),
                              fastest.empty() ? rate_text(bus.kind, most) : fastest));
    return;
  }
  const auto wanted = static_cast<double>(bus.rate);
  const double made = nearest_rate(port, bus.kind, wanted), of_driver = made_rate(port, bus.kind, wanted);
  const double error = rate_error(port, bus.kind, wanted);
  if (error * 1e6 <= static_cast<double>(port.max_rate_error_ppm)) return;
  const std::string nearest = rate_text(bus.kind, std::llround(made));
  auto& finding = report();
  if (of_driver != made)
    finding.note(fmt::format("its driver makes {} of it, the fastest that is not above it; the nearest is {}",
                             rate_text(bus.kind, std::llround(of_driver)), nearest));
  else
    finding.note(fmt::format("the nearest rate is {}, {:.1f} % away; {:.1f} % is the limit", nearest, error * 100,
                             static_cast<double>(port.max_rate_error_ppm) / 1e4));
  if (made > static_cast<double>(parts)) {
    const std::string clock = fastest_clock(&port, bus.kind, parts);
    finding.hint(clock.empty()
                     ? "no clock of this port suits all devices on it: choose another port"
                     : fmt::format("write {}=\"{}\", the fastest for the devices on it", attribute.name, clock));
    return;
  }
  const double slower = nearest_rate(port, bus.kind, made / 2);
  const bool has_slower = has_few_rates(port, bus.kind) && wanted < made && slower < made;
  finding.hint(has_slower ? fmt::format("write {}=\"{}\", or the next slower one, \"{}\"", attribute.name, nearest,
                                        rate_text(bus.kind, std::llround(slower)))
                          : fmt::format("write {}=\"{}\"", attribute.name, nearest));
}

/// A rate that every device on the bus can be set to and the port makes; the usual one when none is.
std::string example_setting(const Bus& bus, const Port* port, const std::vector<const DeviceType*>& types) {
  const std::int64_t usual = bus_type(bus.kind).rate.example;
  std::vector<std::int64_t> candidates{usual};
  for (const DeviceType* type : types) candidates.insert(candidates.end(), type->rates.begin(), type->rates.end());
  const auto suits = [&](std::int64_t rate) {
    return (port == nullptr || is_made(*port, bus.kind, rate)) &&
           std::all_of(types.begin(), types.end(), [&](const DeviceType* type) {
             return type->rates.empty() || std::find(type->rates.begin(), type->rates.end(), rate) != type->rates.end();
           });
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), suits);
  return rate_text(bus.kind, found == candidates.end() ? usual : *found);
}

/// A rate that the devices on the bus can do and the port makes, as the bus would write it; empty when there is none.
/// Without a port, one of the port that is offered for it.
std::string example_rate(Reading& reading, const Bus& bus, const Port* port) {
  const BusRate& rate = bus_type(bus.kind).rate;
  const std::vector<const DeviceType*> types = types_on(reading, bus.name.text);
  const std::string offered = port == nullptr ? example_port(reading, bus.kind) : std::string();
  if (!offered.empty()) port = reading.robot.board->port(offered);
  if (!rate.form->is_clock) return example_setting(bus, port, types);
  return fastest_clock(port, bus.kind, std::min(rate.example, clock_of_parts(reading, bus.name.text)));
}

/// The unit that a rate without one was probably meant in: the port can run at it.
units::Fault with_meant_rate(units::Fault fault, std::string_view text, const RateForm& form, const Port* port) {
  const std::int64_t least = port != nullptr ? port->min_rate.value_or(form.slowest) : form.slowest;
  const std::int64_t most = port != nullptr ? port->max_rate.value_or(INT64_MAX) : INT64_MAX;
  return units::with_meant_unit(std::move(fault), text, {form.units[0], form.units[1], form.units[2]}, form.parse,
                                static_cast<double>(least), static_cast<double>(most));
}

/// Reports rates written as other kinds write theirs.
/// @return  whether the tag has a rate under another name only
bool report_other_rates(Reading& reading, const xml::Node& tag, BusKind kind) {
  const std::string_view wanted = rate_attribute(kind);
  for (const RateForm* form : rate_forms()) {
    const std::string_view name = form->attribute;
    const xml::Attribute* attribute = tag.attribute(name);
    if (attribute == nullptr || name == wanted) continue;
    auto& finding = reading.diagnostics.error(code::attribute_unused, attribute->at,
                                              fmt::format("a bus of type '{}' has no '{}'", bus_kind_name(kind), name));
    finding.underline(name.size());
    finding.hint(wanted.empty() ? fmt::format("remove {}=\"{}\"", name, attribute->value)
                                : fmt::format("its rate is written {}=\"...\"", wanted));
    if (!wanted.empty() && tag.attribute(wanted) == nullptr) return true;
  }
  return false;
}

/// A bus without a rate runs at the fastest of its port, where its kind has a usual one.
void read_no_rate(Reading& reading, const xml::Node& tag, Bus& bus, Reading::BusState& state) {
  const BusRate& rate = bus_type(bus.kind).rate;
  const std::string_view wanted = rate.form->attribute;
  if (reading.tags.is_misspelt(tag, wanted)) return;
  if (!rate.may_be_left_out) {
    const std::string example = example_rate(reading, bus, state.port);
    at_tag(reading.diagnostics, code::attribute_missing, tag,
           fmt::format("bus '{}' has no '{}'", bus.name.text, wanted))
        .hint(example.empty() ? fmt::format("no {} of this port suits all devices on it: choose another port", wanted)
                              : fmt::format("add for example {}=\"{}\"", wanted, example));
  } else if (state.port != nullptr) {
    bus.rate = state.port->max_rate.value_or(0);
    state.rate_is_known = true;
  }
}

}  // namespace

void read_rate(Reading& reading, const xml::Node& tag, Bus& bus, Reading::BusState& state) {
  const RateForm* form = bus_type(bus.kind).rate.form;
  if (report_other_rates(reading, tag, bus.kind) || form == nullptr) return;
  const xml::Attribute* attribute = tag.attribute(form->attribute);
  if (attribute == nullptr) return read_no_rate(reading, tag, bus, state);
  const auto rate = form->parse(attribute->value);
  if (!rate) {
    const units::Fault fault = with_meant_rate(rate.fault(), attribute->value, *form, state.port);
    auto& finding =
        at_value(reading.diagnostics, fault.code, *attribute, fmt::format("{}: {}", form->attribute, fault.message));
    if (!fault.hint.empty()) finding.hint(fault.hint);
    return;
  }
  if (*rate == 0) {
    at_value(reading.diagnostics, code::rate_unreachable, *attribute,
             fmt::format("'{}' of a bus is zero", form->attribute));
    return;
  }
  bus.rate = *rate;
  state.rate_is_known = true;
  if (state.port != nullptr) check_rate(reading, *attribute, *state.port, bus);
}

}  // namespace finemote::gen
