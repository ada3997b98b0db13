// The names and comments that several generated files share.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/template.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Everything an emitter reads. Plain references: nothing is changed.
struct Plan {
  const Robot& robot;
  const Forest& forest;
  const Schedule& schedule;
};

/// `ms5837 on 'seg1'`, `group`.
std::string device_comment(const Plan& plan, DeviceId device);

/// A class that a descriptor names, as generated code names it wherever it stands: no name of a robot hides
/// namespace finemote, any may hide a user's.
std::string class_name(const std::string& qualified);

/// What every template begins with: source, robot, robot_space.
Data common_data(const Plan& plan);

/// `<finemote/stage.hpp>` or `"buses.hpp"` lines as template data; sorted, without repetition.
Data include_list(std::vector<std::string> includes);

}  // namespace finemote::gen
