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

/// `::FinsROV::i2c`: found from inside any tree, whatever its devices are called.
std::string bus_reference(const Plan& plan, const std::string& cpp_name);

/// `ms5837 on 'seg1'`, `group`.
std::string device_comment(const Plan& plan, DeviceId device);

/// `finemote::pin_number('A', 0)` for PA0.
std::string pin_number(const std::string& pin);

/// What every template begins with: source, robot, robot_space.
Data common_data(const Plan& plan);

/// `<finemote/stage.hpp>` or `"buses.hpp"` lines as template data; sorted, without repetition.
Data include_list(std::vector<std::string> includes);

}  // namespace finemote::gen
