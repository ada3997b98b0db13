#include "generator/emit/number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace finemote::gen {

NoFloat::NoFloat(double value) : std::domain_error(fmt::format("{:.6g}, which no float holds", value)) {}

std::string float_literal(double value) { return given_float_literal(std::fabs(value) < 1e-12 ? 0 : value); }

std::string given_float_literal(double value) {
  if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) throw NoFloat(value);
  if (value == 0) value = 0;  // also turns -0 into 0
  std::string text = fmt::format("{:.9g}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

}  // namespace finemote::gen
