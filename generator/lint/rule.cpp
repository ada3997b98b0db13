#include "generator/lint/rule.hpp"

#include <algorithm>

namespace finemote::gen {

const Device& CheckedGeometry::child_of(const std::string& name) const {
  const auto found = std::find_if(device.children.begin(), device.children.end(),
                                  [&](DeviceId child) { return robot.devices[child].joint == name; });
  return robot.devices[*found];
}

}  // namespace finemote::gen
