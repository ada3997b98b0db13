#include "generator/run/bring_up.hpp"

#include <algorithm>

#include "generator/run/emulation.hpp"

namespace finemote::gen {

nlohmann::ordered_json awaited_parts(const Robot& robot) {
  auto list = nlohmann::ordered_json::array();
  for (const Expander& expander : robot.expanders) {
    if (has_part(robot, expander) && !expander.type->is_mux())
      list.push_back({{"part", expander.name.text}, {"output", true}});
  }
  for (const Device& device : robot.devices) {
    if (device.type->acquisition && has_part(robot, device))
      list.push_back({{"part", device.name.text}, {"output", false}});
  }
  return list;
}

Duration shortest_bring_up(const Robot& robot) {
  Duration shortest;
  for (const Device& device : robot.devices) shortest = std::max(shortest, device.type->bring_up);
  return shortest;
}

Duration longest_bring_up(const Robot& robot) {
  Duration longest = std::max(Acquisition().bring_up, shortest_bring_up(robot));
  for (const Device& device : robot.devices) {
    if (device.type->acquisition) longest = std::max(longest, device.type->acquisition->bring_up);
  }
  return longest;
}

}  // namespace finemote::gen
