#include "generator/run/repeated_outputs.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace finemote::gen {
namespace {

/// Names of the expanders that devices of several periods drive.
std::set<std::string> shared_expanders(const Robot& robot) {
  std::map<std::string, Duration> period_of;
  std::set<std::string> shared;
  for (const Device& device : robot.devices) {
    if (!device.segment || robot.segments[*device.segment].kind != Segment::Kind::pwm_expander) continue;
    const std::string& name = robot.expanders[*robot.segments[*device.segment].expander].name.text;
    const auto [known, is_new] = period_of.emplace(name, device.period);
    if (!is_new && known->second != device.period) shared.insert(name);
  }
  return shared;
}

}  // namespace

void note_repeated(const Robot& robot, std::vector<PartRecord>& parts) {
  const std::set<std::string> shared = shared_expanders(robot);
  std::map<std::pair<std::string, std::uint32_t>, double> shown;
  for (PartRecord& event : parts) {
    if (!event.is_output || shared.count(event.part) == 0) continue;
    const auto [before, is_first] = shown.emplace(std::pair(event.part, event.channel), event.value);
    event.is_repeated = !is_first && before->second == event.value;
    before->second = event.value;
  }
}

}  // namespace finemote::gen
