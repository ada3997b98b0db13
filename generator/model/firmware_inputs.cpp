#include "generator/model/firmware_inputs.hpp"

#include <algorithm>

namespace finemote::gen {

std::vector<std::string> user_include_dirs(const Robot& robot) {
  std::vector<std::string> dirs;
  const auto add = [&](const std::string& dir) {
    if (!dir.empty() && std::find(dirs.begin(), dirs.end(), dir) == dirs.end()) dirs.push_back(dir);
  };
  for (const Device& device : robot.devices) add(device.type->include_dir);
  for (const Expander& expander : robot.expanders) add(expander.type->include_dir);
  return dirs;
}

bool runs_code_in_sram(const Robot& robot) {
  return param_value(robot.board_params, "code", std::string("flash")) == "sram";
}

}  // namespace finemote::gen
