// Values to the C++ that spells them: literals, durations, enumerators.
#pragma once

#include <string>

#include "generator/model/robot.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// `20 * finemote::kMillisecond`: in the largest unit that divides it.
std::string duration_expression(Duration time);

/// `"a \"b\""`: the text as C++ writes it, quotes included.
std::string string_literal(const std::string& text);

/// A value as C++ of exactly the type that a Config member for the param has (docs/howto/add-a-device.md): `1024`,
/// `20 * finemote::kMillisecond`, `0.25f`, `my::Mode::kFast`.
std::string value_expression(const ParamSpec& spec, const ParamValue& value);

}  // namespace finemote::gen
