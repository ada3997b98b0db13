// Hardware as ROS describes it to a <finemote> element to start from.
#pragma once

#include <string>
#include <vector>

#include "generator/ros2_control/hardware.hpp"

namespace finemote::gen::ros2_control {

/// What ROS does not say is guessed; every guess stands in a comment `guess: ...` above the element it is about.
struct Proposal {
  std::string text;                  ///< the element, indented by two blanks, with a line break at its end
  std::vector<std::string> guesses;  ///< in the order of the text
  std::vector<std::string> lacking;  ///< what nothing stands for
};

/// A tree for each <ros2_control> element, a device for each part that this project has a driver for: joints with a
/// position command are servos, with a velocity or effort command CAN motors, with a thrust command thrusters, sensors
/// with an orientation attitude sensors.
Proposal propose(const std::vector<Hardware>& all);

}  // namespace finemote::gen::ros2_control
