#include "generator/run/bring_up.hpp"

#include <algorithm>

#include "generator/model/connection.hpp"
#include "generator/run/emulation.hpp"

namespace finemote::gen {
namespace {

/// The set-up of the shipped part with most steps, one in a job, is over in so many.
constexpr std::int64_t kMostSetUpJobs = 20;
/// More is not waited for a part that may never come.
constexpr Duration kLongestSetUp = seconds(100);

/// A sensor, or what is on an expander: each job takes the set-up one step on, or the first data.
bool is_set_up_by_jobs(const Robot& robot, const Device& device) {
  if (device.type->acquisition) return true;
  const std::vector<Connection> connections = connections_of(device);
  return std::any_of(connections.begin(), connections.end(), [&](const Connection& connection) {
    return robot.segments[connection.segment].kind == Segment::Kind::pwm_expander;
  });
}

}  // namespace

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
    if (is_set_up_by_jobs(robot, device))
      longest = std::max(longest, std::min(kMostSetUpJobs * device.period, kLongestSetUp));
  }
  return longest;
}

}  // namespace finemote::gen
