#include "generator/geometry/range.hpp"

#include <algorithm>
#include <limits>

#include "generator/geometry/frame.hpp"

namespace finemote::gen {
namespace {

constexpr double kNoLimit = std::numeric_limits<float>::max();  // rad, on the target

}  // namespace

std::optional<Range> limits_of(const Joint& joint) {
  if (joint.type != "revolute") return std::nullopt;
  return Range{joint.lower.value_or(0), joint.upper.value_or(0)};
}

Range common(const Range& one, const Range& other) {
  return {std::max(one.lower, other.lower), std::min(one.upper, other.upper)};
}

Range within_travel(const Range& range, double travel) { return common(range, {-travel / 2, travel / 2}); }

std::optional<Range> limits_along(const Mechanism& mechanism, const std::string& device_link,
                                  const GeometrySpec& geometry, const std::string& name) {
  const Joint* joint = mechanism.joint(name);
  const auto limits = joint == nullptr ? std::nullopt : limits_of(*joint);
  if (!limits || geometry.along.empty()) return limits;
  const auto axis = joint_axis(mechanism, name, geometry_link(mechanism, device_link, geometry, {name}));
  const bool is_reversed = axis && axis->direction[geometry.along[0] - 'x'] < 0;
  return is_reversed ? Range{-limits->upper, -limits->lower} : *limits;
}

Range allowed_range(const std::vector<Param>& params, const GeometrySpec& geometry) {
  return {param_value(params, geometry.lowest, -kNoLimit), param_value(params, geometry.highest, kNoLimit)};
}

std::vector<Range> role_ranges(const Mechanism& mechanism, const std::string& device_link,
                               const std::vector<Param>& params, const GeometrySpec& geometry,
                               const std::vector<std::string>& joints) {
  const Range allowed = allowed_range(params, geometry);
  std::vector<Range> ranges;
  bool is_limited = false;
  for (const std::string& joint : joints) {
    const auto limits = limits_along(mechanism, device_link, geometry, joint);
    ranges.push_back(limits ? common(*limits, allowed) : allowed);
    is_limited = is_limited || limits;
  }
  return is_limited ? ranges : std::vector<Range>{};
}

double geometry_param(const std::vector<Param>& params, const GeometrySpec& geometry) {
  return param_value(params, geometry.param, 0.0);
}

}  // namespace finemote::gen
