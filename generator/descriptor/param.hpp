// Params of devices, expanders and boards: what a descriptor asks for, and what a robot gives.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace finemote::gen {

/// Base units of params: everything is stored exactly in the base unit.
enum class Unit { none, time_ns, frequency_hz, bit_rate, bits, percent };

enum class ParamKind { integer, real, boolean, text, enumeration };

/// A checked value in its base unit. Enumerations hold their spelling.
using ParamValue = std::variant<std::int64_t, double, bool, std::string>;

struct ParamSpec {
  std::string name;
  ParamKind kind = ParamKind::integer;
  Unit unit = Unit::none;
  std::string unit_text;            ///< for kinds without conversion (`deg`, `mm`): documentation only
  std::optional<double> min, max;   ///< inclusive, base unit
  std::string at_least;             ///< the param whose value it is not below; empty: none
  bool is_pulse = false;            ///< the device sends pulses as long as this
  bool limits_command_age = false;  ///< with older data behind its command the device goes to its safe output
  std::vector<std::string> values;  ///< allowed spellings of an enumeration, or of an integer given as a list
  std::map<std::string, std::string> enumerators;  ///< spelling -> C++ enumerator
  std::optional<ParamValue> fallback;              ///< the default; none: the param is required
  std::string summary;
};

/// A param with its value: as given, or the descriptor's default.
struct Param {
  const ParamSpec* spec = nullptr;
  ParamValue value;
  bool given = false;
};

/// The param called `name`; null when there is none.
inline const Param* find_param(const std::vector<Param>& params, std::string_view name) {
  for (const Param& param : params) {
    if (param.spec->name == name) return &param;
  }
  return nullptr;
}

/// The value of the param called `name`; `fallback` when there is none that holds a T.
template <class T>
T param_value(const std::vector<Param>& params, std::string_view name, T fallback) {
  const Param* param = find_param(params, name);
  const T* value = param != nullptr ? std::get_if<T>(&param->value) : nullptr;
  return value != nullptr ? *value : fallback;
}

}  // namespace finemote::gen
