#include "tests/evidence/findings.hpp"

#include <algorithm>
#include <numbers>

namespace finemote::evidence {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kGravity = 9.80665;
constexpr double kZeroCelsius = 273.15;

/// What a field's name ends in.
struct Unit {
  const char* suffix;
  Dimension dimension;
  double factor, offset = 0;
};

constexpr Unit kUnits[] = {
    {"rad", Dimension::angle, 1},
    {"mrad", Dimension::angle, 1e-3},
    {"deg", Dimension::angle, kDegree},
    {"turns", Dimension::angle, 360 * kDegree},
    {"rad_s", Dimension::angular_speed, 1},
    {"deg_s", Dimension::angular_speed, kDegree},
    {"dps", Dimension::angular_speed, kDegree},
    {"rpm", Dimension::angular_speed, 6 * kDegree},
    {"m_s2", Dimension::acceleration, 1},
    {"g", Dimension::acceleration, kGravity},
    {"mg", Dimension::acceleration, 1e-3 * kGravity},
    {"a", Dimension::current, 1},
    {"ma", Dimension::current, 1e-3},
    {"v", Dimension::voltage, 1},
    {"mv", Dimension::voltage, 1e-3},
    {"nm", Dimension::torque, 1},
    {"mnm", Dimension::torque, 1e-3},
    {"c", Dimension::temperature, 1},
    {"k", Dimension::temperature, 1, -kZeroCelsius},
    {"pa", Dimension::pressure, 1},
    {"hpa", Dimension::pressure, 100},
    {"mbar", Dimension::pressure, 100},
    {"kpa", Dimension::pressure, 1000},
    {"bar", Dimension::pressure, 100'000},
    {"t", Dimension::field, 1},
    {"mt", Dimension::field, 1e-3},
    {"ut", Dimension::field, 1e-6},
    {"nt", Dimension::field, 1e-9},
    {"gauss", Dimension::field, 1e-4},
    {"milligauss", Dimension::field, 1e-7},
    {"mgauss", Dimension::field, 1e-7},
    {"s", Dimension::time, 1},
    {"ms", Dimension::time, 1e-3},
    {"us", Dimension::time, 1e-6},
    {"ns", Dimension::time, 1e-9},
    {"hz", Dimension::frequency, 1},
    {"khz", Dimension::frequency, 1000},
    {"unit", Dimension::share, 1},
    {"percent", Dimension::share, 0.01},
};

/// `name` without `_suffix`; nothing where it does not end so.
std::optional<std::string> without(const std::string& name, const std::string& suffix) {
  if (name == suffix) return std::string();
  const std::string end = "_" + suffix;
  if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0) return {};
  return name.substr(0, name.size() - end.size());
}

unsigned number_in(const Json& value) {
  return value.is_string() ? number_of(value.get<std::string>()) : value.get<unsigned>();
}

}  // namespace

std::vector<Setting> settings_of(const Json& writes) {
  std::vector<Setting> settings;
  for (const Json& entry : writes)
    settings.push_back(
        {number_in(entry.at("reg")), number_in(entry.at("value")), entry.value("min_wait_after_ns", std::int64_t{0})});
  return settings;
}

void Findings::put(std::initializer_list<const char*> names, Dimension dimension, std::vector<double> values,
                   Tolerance tolerance, double turn) {
  for (const char* name : names) findings_[name] = Finding{dimension, values, tolerance, turn, {}};
}

void Findings::put_least(const char* name, Dimension dimension, double value) {
  put({name}, dimension, {value});
  findings_[name].at_least = true;
}

void Findings::put_text(const char* name, std::vector<std::string> texts) {
  Finding finding;
  finding.texts = std::move(texts);
  findings_[name] = finding;
}

void Findings::check(const std::string& what, bool holds) {
  if (!holds) failed_.push_back(what);
}

Findings::Named Findings::find(const std::string& field) const {
  if (const auto found = findings_.find(field); found != findings_.end()) return {&found->second};
  for (const Unit& unit : kUnits) {
    const std::optional<std::string> name = without(field, unit.suffix);
    if (!name) continue;
    const auto found = findings_.find(*name);
    if (found != findings_.end() && found->second.dimension == unit.dimension)
      return {&found->second, unit.factor, unit.offset};
  }
  return {};
}

bool Findings::is_prose(const std::string& field) const {
  return field == "note" || std::find(prose_.begin(), prose_.end(), field) != prose_.end();
}

}  // namespace finemote::evidence
