#include "generator/emit/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace finemote::gen {

std::string float_literal(double value) {
  if (std::fabs(value) < 1e-12) value = 0;  // also turns -0 into 0
  std::string text = fmt::format("{:.9g}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

}  // namespace finemote::gen
