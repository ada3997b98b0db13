// The `params` of a descriptor or board file to ParamSpecs.
#pragma once

#include <vector>

#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reads the array `params` of `owner` (none: no params). Reports FM3103: a name twice, max below min, a default that
/// is out of range, of another type or no value of the enumeration, `at_least` what it cannot be, and FM3030 to FM3034
/// for a quantity that is wrong.
std::vector<ParamSpec> read_params(const Json& owner, const Origin& origin, Diagnostics& diagnostics);

/// A text to a value as `spec` wants it, or the fault; ranges are checked too (FM3025, FM3026, FM3030 to FM3034).
struct ParamFault {
  Code code;
  std::string message;
  std::string hint;
};
std::variant<ParamValue, ParamFault> parse_param(const ParamSpec& spec, std::string_view text);

/// A number in the base unit; 0 for what is none.
double number_of(const ParamValue& value);
/// It as the URDF writes it, with its unit.
std::string number_text(const ParamSpec& spec, double value);

/// The spec of this name; null: there is none.
const ParamSpec* find_spec(const std::vector<ParamSpec>& specs, std::string_view name);

}  // namespace finemote::gen
