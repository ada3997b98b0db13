// The <ros2_control> elements of a robot to what they say of its hardware.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/xml/node.hpp"

namespace finemote::gen::ros2_control {

struct Component {
  enum class Kind { joint, sensor, gpio, transmission };
  Kind kind = Kind::joint;
  std::string name;
  std::vector<std::string> commands, states;  ///< names of its interfaces, in document order
  bool is_mimic = false;                      ///< a joint that another one moves
  std::string type;                           ///< of the robot's joint of that name: `continuous`; empty: it has none
  std::string link;                           ///< of the robot, that a sensor's data refer to; empty: none is named
  Position at;                                ///< its tag

  /// The robot has that joint, and it turns.
  [[nodiscard]] bool can_turn() const { return type == "revolute" || type == "continuous"; }
};

/// One <ros2_control> element.
struct Hardware {
  std::string name;
  std::string plugin;            ///< empty: none is named
  std::optional<double> rate;    ///< rw_rate [Hz]; none where it is absent, zero or no number
  std::vector<Component> parts;  ///< in document order
};

/// Elements and attributes without a meaning here are skipped, as ROS does.
std::vector<Hardware> read_hardware(const xml::Node& robot);

}  // namespace finemote::gen::ros2_control
