// C++ names of the user's device types and expanders that lie where the names of the robot do.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "generator/model/robot.hpp"

namespace finemote::gen {

class TakenNames {
 public:
  explicit TakenNames(const Robot& robot);

  /// What has the robot's own name, or a name that generated code keeps in the robot's namespace: "the class
  /// 'my::slots' of type 'meter'"; empty: nothing.
  [[nodiscard]] const std::string& robot_taken() const { return robot_taken_; }
  /// What has a name in the robot's namespace; empty: nothing.
  [[nodiscard]] std::string in_robot(std::string_view cpp) const;

 private:
  void add(const std::string& qualified, const char* what, const std::string& type);
  void add_params(const std::vector<ParamSpec>& params, const std::string& type);

  std::string robot_;
  std::string robot_taken_;
  std::map<std::string, std::string, std::less<>> inside_;
};

}  // namespace finemote::gen
