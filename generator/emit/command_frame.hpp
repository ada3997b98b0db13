// What a computer sends down a device's link.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The frame of commands.
struct CommandFrame {
  std::uint32_t layout = 0;  ///< number that the frame carries
  std::string values;  ///< a letter for each, as struct of Python has them; `v`: a command begins, with its validity
};

/// Of links with commands.
using CommandFrames = std::map<DeviceId, CommandFrame>;

}  // namespace finemote::gen
