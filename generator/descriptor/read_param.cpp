#include "generator/descriptor/read_param.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "generator/descriptor/cpp_words.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Parsed = std::variant<ParamValue, ParamFault>;

Unit exact_unit(std::string_view text) {
  if (text == "ns") return Unit::time_ns;
  if (text == "Hz") return Unit::frequency_hz;
  if (text == "bit/s") return Unit::bit_rate;
  if (text == "bit") return Unit::bits;
  if (text == "%") return Unit::percent;
  return Unit::none;
}

template <typename T>
Parsed wrap(const units::Result<T>& result) {
  if (result) return ParamValue(*result);
  const units::Fault& fault = result.fault();
  const bool is_type_error = fault.code == code::quantity_malformed;
  return ParamFault{is_type_error ? code::param_type : fault.code, fault.message, fault.hint};
}

/// A param counts its times in nanoseconds: its value is a number, with the unit beside it.
Parsed wrap(const units::Result<Duration>& time) {
  return time ? wrap(units::Result<std::int64_t>((*time).ns())) : wrap(units::Result<std::int64_t>(time.fault()));
}

/// A number whose unit is documentation: the unit may follow, it need not.
Parsed parse_documented(const ParamSpec& spec, std::string_view text) {
  return spec.kind == ParamKind::integer ? wrap(units::parse_integer(text, spec.unit_text))
                                         : wrap(units::parse_real(text, spec.unit_text));
}

Parsed parse_number(const ParamSpec& spec, std::string_view text) {
  switch (spec.unit) {
    case Unit::time_ns:
      return wrap(units::parse_duration(text));
    case Unit::frequency_hz:
      return wrap(units::parse_frequency(text));
    case Unit::bit_rate:
      return wrap(units::parse_bitrate(text));
    case Unit::bits:
      return wrap(units::parse_bits(text));
    case Unit::percent:
      return wrap(units::parse_percent(text));
    case Unit::none:
      break;
  }
  return parse_documented(spec, text);
}

Parsed parse_boolean(std::string_view text) {
  if (text == "true" || text == "false") return ParamValue(text == "true");
  return ParamFault{code::param_type, fmt::format("'{}' is neither 'true' nor 'false'", text), {}};
}

Parsed parse_enumeration(const ParamSpec& spec, std::string_view text) {
  if (std::find(spec.values.begin(), spec.values.end(), text) != spec.values.end())
    return ParamValue(std::string(text));
  return ParamFault{code::param_range, fmt::format("'{}' is not one of its values", text),
                    did_you_mean(text, spec.values)};
}

/// The unit that the default is written in; empty: there is none.
std::string usual_time_unit(const ParamSpec& spec) {
  const auto* usual = spec.fallback ? std::get_if<std::int64_t>(&*spec.fallback) : nullptr;
  if (usual == nullptr) return {};
  const std::string text = units::format_duration(nanoseconds(*usual));
  return text.substr(text.find_first_not_of("0123456789."));
}

/// A number without unit: the unit it was probably meant in is the one of its default, else one that brings it into the
/// range.
ParamFault with_meant_unit(const ParamSpec& spec, std::string_view text, ParamFault fault) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const double least = spec.min.value_or(-kAny), most = spec.max.value_or(kAny);
  units::Fault meant{fault.code, fault.message, fault.hint};
  const auto try_units = [&](std::initializer_list<std::string_view> preferred, auto parse) {
    meant = units::with_meant_unit(std::move(meant), text, preferred, parse, least, most);
  };
  if (spec.unit == Unit::time_ns) {
    const std::string usual = usual_time_unit(spec);
    try_units({usual, "ms", "us", "s", "ns"}, units::parse_duration);
  } else if (spec.unit == Unit::frequency_hz) {
    const bool is_large = text.size() > 3;
    try_units({is_large ? "Hz" : "kHz", "kHz", "Hz", "MHz"}, units::parse_frequency);
  } else if (spec.unit == Unit::bit_rate) {
    try_units({"bit/s", "kbit/s", "Mbit/s"}, units::parse_bitrate);
  }
  fault.hint = meant.hint;
  return fault;
}

std::optional<ParamFault> check_range(const ParamSpec& spec, const ParamValue& value, std::string_view text) {
  const double number = number_of(value);
  const bool low = spec.min && number < *spec.min;
  const bool high = spec.max && number > *spec.max;
  if (low || high) {
    const std::string range =
        spec.min && spec.max
            ? fmt::format("write a value from {} to {}", number_text(spec, *spec.min), number_text(spec, *spec.max))
        : spec.min ? fmt::format("the minimum is {}", number_text(spec, *spec.min))
                   : fmt::format("the maximum is {}", number_text(spec, *spec.max));
    return ParamFault{code::param_range, fmt::format("'{}' is out of range", text), range};
  }
  const auto* integer = std::get_if<std::int64_t>(&value);
  const bool is_plain = spec.kind == ParamKind::integer && spec.unit == Unit::none;
  const bool fits = integer == nullptr || (*integer >= std::numeric_limits<std::int32_t>::min() &&
                                           *integer <= std::numeric_limits<std::int32_t>::max());
  if (is_plain && !fits) return ParamFault{code::param_range, fmt::format("'{}' does not fit 32 bits", text), {}};
  if (spec.kind == ParamKind::real && !(std::fabs(number) <= static_cast<double>(std::numeric_limits<float>::max())))
    return ParamFault{code::param_range, fmt::format("'{}' is larger than a float holds", text), {}};
  const bool is_nearly_zero = number != 0 && std::fabs(number) < static_cast<double>(std::numeric_limits<float>::min());
  if (spec.kind == ParamKind::real && is_nearly_zero)
    return ParamFault{code::param_range, fmt::format("'{}' is smaller than a float holds", text), "for none write 0"};
  const auto* written = std::get_if<std::string>(&value);
  constexpr std::size_t kLongest = 65535;  // of a string literal that every compiler of C++ takes
  if (written != nullptr && written->size() > kLongest)
    return ParamFault{code::param_range, fmt::format("a text of {} bytes is too long", written->size()),
                      fmt::format("write at most {} bytes", kLongest)};
  return {};
}

/// An integer or real given as a list of values: the value has to be one of them, however it is spelt.
std::optional<ParamFault> check_values(const ParamSpec& spec, const ParamValue& value, std::string_view text) {
  if (spec.values.empty()) return {};
  for (const std::string& allowed : spec.values) {
    const Parsed parsed = parse_number(spec, allowed);
    if (parsed.index() == 0 && std::get<0>(parsed) == value) return {};
  }
  return ParamFault{code::param_range, fmt::format("'{}' is not one of its values", text),
                    did_you_mean(text, spec.values)};
}

ParamKind kind_named(std::string_view type) {
  if (type == "float") return ParamKind::real;
  if (type == "bool") return ParamKind::boolean;
  if (type == "string") return ParamKind::text;
  if (type == "enum") return ParamKind::enumeration;
  return ParamKind::integer;
}

/// A value of a descriptor as the URDF would write it.
std::string as_text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Reads one entry of `params`; what is wrong is shown at its member.
class SpecReader {
 public:
  SpecReader(const Json& value, std::size_t index, const Origin& origin, Diagnostics& diagnostics)
      : value_(value), index_(index), origin_(origin), diagnostics_(diagnostics) {}

  ParamSpec read() {
    spec_.name = value_.at("name").get<std::string>();
    if (const auto fault = invalid_name(spec_.name))
      complain({"name"}, code::descriptor_contradiction, "the name " + *fault + ", so no member of Config can have it");
    spec_.kind = kind_named(value_.at("type").get<std::string>());
    spec_.unit_text = value_.value("unit", "");
    spec_.unit = exact_unit(spec_.unit_text);
    spec_.summary = value_.value("summary", "");
    read_values();
    read_range();
    read_default();
    spec_.at_least = value_.value("at_least", "");
    const std::string limits = value_.value("limits", "");
    spec_.limits_command_age = limits == "command_age";
    spec_.is_pulse = limits == "pulse" && spec_.unit == Unit::time_ns;
    return std::move(spec_);
  }

 private:
  void complain(const JsonPath& member, Code code, const std::string& message) {
    JsonPath path{"params", std::to_string(index_)};
    path.insert(path.end(), member.begin(), member.end());
    const Extent extent = find_value(origin_, path);
    diagnostics_.error(code, extent.at, fmt::format("param '{}': {}", spec_.name, message)).underline(extent.length);
  }
  void read_values() {
    if (const auto values = value_.find("values"); values != value_.end()) {
      for (const Json& entry : *values) spec_.values.push_back(as_text(entry));
    }
    const auto enumerators = value_.find("enumerators");
    if (enumerators == value_.end()) return;
    for (const auto& [spelling, enumerator] : enumerators->items())
      spec_.enumerators[spelling] = enumerator.get<std::string>();
    for (const std::string& spelling : spec_.values) {
      if (spec_.enumerators.count(spelling) == 0)
        complain({"enumerators"}, code::descriptor_contradiction,
                 fmt::format("the value '{}' has no enumerator", spelling));
    }
  }
  void read_range() {
    const auto range = value_.find("range");
    if (range == value_.end()) return;
    spec_.min = read_bound(range->at(0), "0");
    spec_.max = read_bound(range->at(1), "1");
    if (spec_.min && spec_.max && *spec_.min > *spec_.max)
      complain({"range", "0"}, code::descriptor_contradiction, "the lowest value is above the highest");
  }
  std::optional<double> read_bound(const Json& bound, const std::string& index) {
    const Parsed parsed = parse_number(spec_, as_text(bound));
    if (parsed.index() == 0) return number_of(std::get<0>(parsed));
    complain({"range", index}, std::get<1>(parsed).code, std::get<1>(parsed).message);
    return {};
  }
  void read_default() {
    const auto fallback = value_.find("default");
    if (fallback == value_.end()) return;
    const Parsed parsed = parse_param(spec_, as_text(*fallback));
    if (parsed.index() == 0) {
      spec_.fallback = std::get<0>(parsed);
    } else {
      complain({"default"}, code::descriptor_contradiction, "the default " + std::get<1>(parsed).message);
    }
  }

  const Json& value_;
  std::size_t index_;
  const Origin& origin_;
  Diagnostics& diagnostics_;
  ParamSpec spec_;
};

/// Why `spec` cannot be at least `lower`; empty: it can.
std::string fault_of_order(const ParamSpec& spec, const ParamSpec* lower) {
  const auto is_number = [](ParamKind kind) { return kind == ParamKind::integer || kind == ParamKind::real; };
  if (lower == nullptr || lower == &spec) return "there is no other param of this name";
  if (!is_number(spec.kind) || lower->kind != spec.kind || lower->unit_text != spec.unit_text)
    return "they are not numbers of one type and unit";
  if (spec.fallback && lower->fallback && number_of(*spec.fallback) < number_of(*lower->fallback))
    return "the default is below its default";
  return {};
}

void check_orders(const std::vector<ParamSpec>& specs, const Origin& origin, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const std::string& lower = specs[i].at_least;
    const std::string fault = lower.empty() ? "" : fault_of_order(specs[i], find_spec(specs, lower));
    if (fault.empty()) continue;
    const Extent extent = find_value(origin, {"params", std::to_string(i), "at_least"});
    diagnostics
        .error(code::descriptor_contradiction, extent.at,
               fmt::format("param '{}' at least '{}': {}", specs[i].name, lower, fault))
        .underline(extent.length);
  }
}

}  // namespace

double number_of(const ParamValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return 0;
}

std::string number_text(const ParamSpec& spec, double value) {
  if (spec.unit == Unit::time_ns) return units::format_duration(nanoseconds(static_cast<std::int64_t>(value)));
  if (spec.unit == Unit::percent) return fmt::format("{}%", value * 100);
  const std::string unit = spec.unit == Unit::none ? "" : spec.unit_text;
  return fmt::format("{}{}", value, unit);
}

const ParamSpec* find_spec(const std::vector<ParamSpec>& specs, std::string_view name) {
  for (const ParamSpec& spec : specs) {
    if (spec.name == name) return &spec;
  }
  return nullptr;
}

std::variant<ParamValue, ParamFault> parse_param(const ParamSpec& spec, std::string_view text) {
  if (spec.kind == ParamKind::text) return ParamValue(std::string(text));
  if (spec.kind == ParamKind::boolean) return parse_boolean(text);
  if (spec.kind == ParamKind::enumeration) return parse_enumeration(spec, text);
  Parsed parsed = parse_number(spec, text);
  if (parsed.index() != 0) return with_meant_unit(spec, text, std::get<1>(parsed));
  if (auto fault = check_values(spec, std::get<0>(parsed), text)) return *fault;
  if (auto fault = check_range(spec, std::get<0>(parsed), text)) return *fault;
  return parsed;
}

std::vector<ParamSpec> read_params(const Json& owner, const Origin& origin, Diagnostics& diagnostics) {
  std::vector<ParamSpec> specs;
  const auto params = owner.find("params");
  if (params == owner.end() || params->is_null()) return specs;
  std::set<std::string> names;
  for (std::size_t i = 0; i < params->size(); ++i) {
    specs.push_back(SpecReader(params->at(i), i, origin, diagnostics).read());
    if (names.insert(specs.back().name).second) continue;
    const Extent extent = find_value(origin, {"params", std::to_string(i), "name"});
    diagnostics
        .error(code::descriptor_contradiction, extent.at, fmt::format("there are two params '{}'", specs.back().name))
        .underline(extent.length);
  }
  check_orders(specs, origin, diagnostics);
  return specs;
}

}  // namespace finemote::gen
