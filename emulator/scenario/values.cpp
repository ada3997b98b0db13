#include "emulator/scenario/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/units/units.hpp"

namespace finemote::scenario {
namespace code = gen::code;
namespace {

constexpr double kExact = 9007199254740992;  // 2^53: integers up to it are exact as double

std::string text_of(double value) {
  if (std::abs(value) < kExact && value == std::floor(value)) return fmt::format("{}", static_cast<long long>(value));
  return fmt::format("{}", value);
}

std::string with_unit(std::string text, const Member& row) {
  return row.unit.empty() ? text : std::move(text) + " " + row.unit;
}

/// `from -1 to 1`, `above 0 kg`, `0 rad or more`, `118`; empty: any.
std::string range_of(const Member& row) {
  if (row.min == -kAny) return {};
  if (row.min == row.max) return with_unit(text_of(row.min), row);
  if (row.max == kAny)
    return with_unit((row.above_min ? "above " : "") + text_of(row.min), row) + (row.above_min ? "" : " or more");
  return with_unit("from " + text_of(row.min) + " to " + text_of(row.max), row);
}

bool is_within(const Member& row, double value) {
  return (row.above_min ? value > row.min : value >= row.min) && value <= row.max;
}

}  // namespace

double number_of(const gen::json::Value& value) {
  double number = 0;
  const char* const end = value.text.data() + value.text.size();
  const auto result = std::from_chars(value.text.data(), end, number);
  if (result.ec == std::errc::result_out_of_range)
    return value.text.find("e-") != std::string::npos || value.text.find("E-") != std::string::npos ? 0 : kAny;
  return result.ec == std::errc() && result.ptr == end ? number : kAny;
}

std::string shown(const gen::json::Value& value) {
  constexpr std::size_t kLongestText = 40;
  const std::string text = value.text.size() > kLongestText ? value.text.substr(0, kLongestText) + "..." : value.text;
  return value.is(gen::json::Value::Kind::string) ? "'" + text + "'" : text;
}

std::string quoted(const std::vector<std::string>& names, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? fmt::format(" {} ", last) : ", ") + fmt::format("'{}'", names[i]);
  return text;
}

bool is_pin(const std::string& pin) {
  const bool digits = pin.size() >= 3 && pin.size() <= 4 && pin.find_first_not_of("0123456789", 2) == std::string::npos;
  const bool plain = digits && (pin.size() == 3 || pin[2] != '0');
  return plain && pin[0] == 'P' && pin[1] >= 'A' && pin[1] <= 'I' &&
         std::stoul(pin.substr(2)) <= (pin[1] == 'I' ? 11U : 15U);
}

bool ValueCheck::is_kind(const std::string& name, const Value& value, Value::Kind kind) {
  if (value.is(kind)) return true;
  auto& finding =
      diagnostics_.error(code::bad_scenario, value.at,
                         fmt::format("'{}' must be {}, got {}", name, gen::json::describe(kind), describe(value.kind)));
  finding.underline(value.length);
  if (kind != Value::Kind::number || !value.is(Value::Kind::string)) return false;
  const Value bare{Value::Kind::number, false, value.text, {}, {}, {}, 1};
  if (const auto time = gen::units::parse_duration(value.text)) {
    finding.hint(fmt::format("for example {}", (*time).ns()));
  } else if (std::isfinite(number_of(bare))) {
    finding.hint(fmt::format("write {} without quotes", value.text));
  }
  return false;
}

bool ValueCheck::out_of_range(const std::string& name, const Value& value, const std::string& wanted) {
  diagnostics_.error(code::scenario_range, value.at, fmt::format("'{}' must be {}, got {}", name, wanted, shown(value)))
      .underline(value.length);
  return false;
}

bool ValueCheck::number(const Member& row, const std::string& name, const Value& value) {
  if (!is_kind(name, value, Value::Kind::number)) return false;
  const double number = number_of(value);
  if (!std::isfinite(number)) return out_of_range(name, value, "a number that a double can hold");
  if (row.kind == Member::Kind::integer && number != std::floor(number))
    return out_of_range(name, value, "a whole number");
  if (!is_within(row, number)) return out_of_range(name, value, range_of(row));
  return true;
}

bool ValueCheck::numbers(const Member& row, const std::string& name, const Value& value, std::size_t count) {
  if (!is_kind(name, value, Value::Kind::array)) return false;
  if (value.items.size() != count) {
    diagnostics_.error(code::bad_scenario, value.at,
                       fmt::format("'{}' has {} values, but needs {}", name, value.items.size(), count));
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) good = number(row, fmt::format("{}[{}]", name, i), value.items[i]) && good;
  return good;
}

bool ValueCheck::word(const Member& row, const std::string& name, const Value& value) {
  if (!is_kind(name, value, Value::Kind::string)) return false;
  const bool is_good = row.kind == Member::Kind::pin
                           ? is_pin(value.text)
                           : std::find(row.choices.begin(), row.choices.end(), value.text) != row.choices.end();
  if (is_good) return true;
  if (row.kind == Member::Kind::pin) return out_of_range(name, value, "a pin of the chip, PA0 to PI11");
  diagnostics_
      .error(code::scenario_range, value.at,
             fmt::format("'{}' must be {}, got {}", name, quoted(row.choices, "or"), shown(value)))
      .underline(value.length)
      .hint(gen::did_you_mean(value.text, row.choices));
  return false;
}

bool ValueCheck::simple(const Member& row, const std::string& name, const Value& value) {
  switch (row.kind) {
    case Member::Kind::flag:
      return is_kind(name, value, Value::Kind::boolean);
    case Member::Kind::integer:
    case Member::Kind::number:
      return number(row, name, value);
    case Member::Kind::vector:
      return numbers(row, name, value, 3);
    case Member::Kind::six:
      return numbers(row, name, value, 6);
    case Member::Kind::choice:
    case Member::Kind::pin:
      return word(row, name, value);
    default:
      return is_kind(name, value, Value::Kind::string);
  }
}

}  // namespace finemote::scenario
