#include "generator/timing/object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen::timing {

using json::Value;

Diagnostic& ObjectReader::error(Code code, const Value& where, std::string message) {
  return diagnostics_.error(code, where.at, std::move(message)).underline(where.length);
}

bool ObjectReader::is_object(const Value& value, std::string_view what) {
  if (value.is(Value::Kind::object)) return true;
  error(code::json_type, value, fmt::format("{} is {}, not an object", what, describe(value.kind)));
  return false;
}

bool ObjectReader::is_array(const Value& value, std::string_view key) {
  if (value.is(Value::Kind::array)) return true;
  error(code::json_type, value, fmt::format("'{}' is {}, not an array", key, describe(value.kind)));
  return false;
}

std::int64_t ObjectReader::integer(const Value& value, std::string_view key, std::int64_t least) {
  if (!value.is(Value::Kind::number)) {
    error(code::json_type, value, fmt::format("'{}' is {}, not an integer", key, describe(value.kind)));
    return least;
  }
  std::int64_t number = 0;
  const char* end = value.text.data() + value.text.size();
  const auto [rest, status] = std::from_chars(value.text.data(), end, number);
  if (status == std::errc::result_out_of_range || (rest == end && number < least)) {
    error(
        code::json_number_range, value,
        fmt::format("'{}' is {}, outside {} to {}", key, value.text, least, std::numeric_limits<std::int64_t>::max()));
    return least;
  }
  if (rest != end) {
    error(code::json_type, value, fmt::format("'{}' is {}, not an integer", key, value.text))
        .hint("write it without fraction and exponent");
    return least;
  }
  return number;
}

bool ObjectReader::flag(const Value& value, std::string_view key) {
  if (!value.is(Value::Kind::boolean)) {
    error(code::json_type, value, fmt::format("'{}' is {}, not true or false", key, describe(value.kind)));
  }
  return value.truth;
}

std::string ObjectReader::text(const Value& value, std::string_view what, std::string_view key) {
  if (!value.is(Value::Kind::string)) {
    error(code::json_type, value, fmt::format("'{}' is {}, not a string", key, describe(value.kind)));
    return {};
  }
  if (value.text.empty()) error(code::timing_name, value, fmt::format("'{}' of {} is empty", key, what));
  return value.text;
}

std::string ObjectReader::member_text(const Value& object, std::string_view what, std::string_view key) {
  if (const Value* value = object.find(key)) return text(*value, what, key);
  report_missing(object, what, key);
  return {};
}

void ObjectReader::check_members(const Value& object, std::string_view what,
                                 const std::vector<std::string_view>& known) {
  for (const json::Member& m : object.members) {
    if (std::find(known.begin(), known.end(), m.key) != known.end()) continue;
    auto& d = diagnostics_.error(code::json_unknown_member, m.at, fmt::format("{} has no member '{}'", what, m.key));
    d.underline(m.key.size() + 2);
    const std::string hint = did_you_mean(m.key, std::vector<std::string>(known.begin(), known.end()));
    if (!hint.empty()) d.hint(hint);
  }
}

void ObjectReader::report_other_word(const json::Value& value, std::string_view key, std::string_view said,
                                     std::string_view list) {
  error(code::json_type, value, fmt::format("'{}' is '{}', not {}", key, said, list));
}

void ObjectReader::report_missing(const Value& object, std::string_view what, std::string_view key) {
  error(code::json_missing_member, object, fmt::format("{} has no '{}'", what, key));
}

}  // namespace finemote::gen::timing
