// <ros2_control> to the commands of joints. What is wrong there is ROS's to report.
#include <algorithm>

#include "generator/model/reading.hpp"
#include "generator/ros2_control/hardware.hpp"

namespace finemote::gen {

/// A joint may stand in several elements, one for each way to run the robot: it then takes what any of them says.
void read_ros_joints(Reading& reading) {
  std::vector<RosJoint>& joints = reading.robot.ros_joints;
  for (const ros2_control::Hardware& hardware : ros2_control::read_hardware(reading.root)) {
    for (const ros2_control::Component& part : hardware.parts) {
      if (part.kind != ros2_control::Component::Kind::joint) continue;
      const auto known =
          std::find_if(joints.begin(), joints.end(), [&](const RosJoint& joint) { return joint.name == part.name; });
      if (known == joints.end()) {
        joints.push_back({part.name, part.commands, part.at});
      } else {
        known->commands.insert(known->commands.end(), part.commands.begin(), part.commands.end());
      }
    }
  }
}

}  // namespace finemote::gen
