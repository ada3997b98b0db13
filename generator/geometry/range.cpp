#include "generator/geometry/range.hpp"

#include <algorithm>

namespace finemote::gen {

std::optional<Range> limits_of(const Joint& joint) {
  if (joint.type != "revolute") return std::nullopt;
  return Range{joint.lower.value_or(0), joint.upper.value_or(0)};
}

Range within_travel(const Range& range, double travel) {
  return {std::max(range.lower, -travel / 2), std::min(range.upper, travel / 2)};
}

double geometry_param(const Device& device, const GeometrySpec& geometry) {
  for (const Param& param : device.params) {
    const auto* value = std::get_if<double>(&param.value);
    if (param.spec->name == geometry.param && value != nullptr) return *value;
  }
  return 0;
}

}  // namespace finemote::gen
