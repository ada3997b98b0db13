#include "generator/report/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "generator/svg/svg.hpp"
#include "generator/timing/table.hpp"

namespace finemote::gen::report {
namespace {

constexpr const char* kNothing = "–";

std::string time_text(const Json& value) {
  if (!value.is_number_integer()) return fmt::format("{} ns", value.dump());  // a mean
  // A document that somebody wrote may hold anything; the least number has no positive one.
  const std::int64_t ns = std::max(value.get<std::int64_t>(), -std::numeric_limits<std::int64_t>::max());
  std::string text = (ns < 0 ? "-" : "") + timing::duration_text(nanoseconds(std::abs(ns)));
  const auto micro = text.find(" us");
  return micro == std::string::npos ? text : text.replace(micro, 3, " µs");
}

/// To as many digits as are shown.
Json rounded_down(const Json& value) {
  if (!value.is_number_integer()) return value;
  const auto ns = value.get<std::int64_t>();
  if (ns < -1'000'000'000'000'000'000) return value;
  const std::int64_t size = std::abs(ns);
  const std::int64_t step = size >= 1'000'000'000 ? 1'000'000 : size >= 1'000'000 ? 1'000 : 1;
  const std::int64_t above = ((ns % step) + step) % step;
  return ns - above;
}

/// What is left of a sum of floating-point numbers that is 0 is shown as 0.
std::string number_text(double value) {
  constexpr double kNothingLeft = 1e-9;
  return fmt::format("{:.6g}", std::abs(value) < kNothingLeft ? 0.0 : value);
}

std::string count_text(const Json& value) {
  std::string text = value.dump();
  if (!value.is_number_integer()) return text;
  for (std::size_t at = text.size(); at > 3 && text[at - 4] != '-'; at -= 3) text.insert(at - 3, "\u202f");
  return text;
}

}  // namespace

std::string shown(const Json& value, Unit unit) {
  if (!value.is_number()) return kNothing;
  switch (unit) {
    case Unit::time:
      return time_text(value);
    case Unit::room:
      return time_text(rounded_down(value));
    case Unit::share:
      return fmt::format("{:.1f} %", 100 * value.get<double>());
    case Unit::bytes:
      return count_text(value) + " B";
    case Unit::count:
      return count_text(value);
    case Unit::number:
      return number_text(value.get<double>());
  }
  return {};
}

Place::Place(const Json& document, std::string_view name)
    : value_(document.is_null() ? nullptr : &document), key_(std::string(name) + "#") {}

Place Place::operator[](std::string_view member) const {
  const Json* found = nullptr;
  if (exists() && value_->is_object()) {
    const auto at = value_->find(std::string(member));
    if (at != value_->end()) found = &*at;
  }
  return {found, key_ + "/" + std::string(member)};
}

Place Place::operator[](std::size_t element) const {
  return {element < size() ? &(*value_)[element] : nullptr, key_ + "/" + std::to_string(element)};
}

std::size_t Place::size() const { return exists() && value_->is_array() ? value_->size() : 0; }

std::string Place::text() const { return exists() && value_->is_string() ? value_->get<std::string>() : ""; }

bool Place::is_true() const { return exists() && value_->is_boolean() && value_->get<bool>(); }

std::string Place::element(std::string_view tag, Unit unit) const {
  if (!exists()) return fmt::format("<{0}>{1}</{0}>", tag, kNothing);
  return fmt::format("<{}{}>{}</{}>", tag, attributes(), shown(*value_, unit), tag);
}

std::string Place::attributes() const {
  if (!exists()) return {};
  return fmt::format(" data-key=\"{}\" data-value=\"{}\"", key_, svg::escaped(value_->dump()));
}

std::string Place::figure(Unit unit) const { return element("span", unit); }

std::string Place::cell(Unit unit) const { return element("td", unit); }

}  // namespace finemote::gen::report
