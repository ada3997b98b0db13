#include "finemote/control/numbers.hpp"

namespace finemote {

float wrap_angle(float angle) {
  constexpr float kPi = 3.14159265359F, kTurn = 2 * kPi, kLargest = 1e6F;
  if (!(angle <= kLargest && angle >= -kLargest)) return 0;
  const float turns = angle / kTurn;
  const auto whole = static_cast<std::int32_t>(turns + (turns < 0 ? -0.5F : 0.5F));
  return clamp(angle - static_cast<float>(whole) * kTurn, -kPi, kPi);
}

}  // namespace finemote
