// A robot to the parts that hang on the emulated board's buses.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/emit/command_frame.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A body that stands although a device says that it moves.
struct UndrivenBody {
  Position at;  ///< of the device
  std::string message;
  std::vector<std::string> notes;  ///< one per child that drives nothing
};

/// What hangs on the board.
struct EmulatedParts {
  /// A `finemote.scenario/1` document (docs/reference/emulator.md): the body, every expander, and every device whose
  /// descriptor names a model (`emulation`), named like the device. A `NAME.node` on CAN for every other device there.
  nlohmann::ordered_json scenario;
  /// Devices on a bus without a model: nobody answers them.
  std::vector<std::string> silent;
  std::vector<UndrivenBody> undriven;
};

/// @param frames  what a computer sends to the robot's links, where something plays it
EmulatedParts emulated_parts(const Robot& robot, const CommandFrames& frames);

}  // namespace finemote::gen
