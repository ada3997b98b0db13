// Physical units of params (m, rad/s, N m, Pa, ...): what a value written in another unit is in the wanted one.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen::units {

/// Whether a param's unit is none: empty, or "1".
bool is_bare(std::string_view unit);

/// `mm`, `N*m`, `rad/s^2`, `%`: whether a text can be a unit at all.
bool looks_like_unit(std::string_view text);

/// `76`, `mm`, `m` -> `0.076`: the number in the unit `to`, with at most 12 digits; empty when no conversion is known.
/// Knows SI prefixes before `to`, other spellings of it, and common units of the same quantity (deg, rpm, bar, km/h,
/// in, % of a bare number). `number` is a decimal number with optional sign and exponent.
std::string convert(std::string_view number, std::string_view unit, std::string_view to);

}  // namespace finemote::gen::units
