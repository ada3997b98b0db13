// A robot to the parts that hang on the emulated board's buses.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// What hangs on the board.
struct EmulatedParts {
  /// A `finemote.scenario/1` document (docs/reference/emulator.md): the body, every expander, and every device whose
  /// descriptor names a model (`emulation`), named like the device.
  nlohmann::ordered_json scenario;
  /// Devices on a bus without a model: their wire stays silent.
  std::vector<std::string> silent;
};

EmulatedParts emulated_parts(const Robot& robot);

}  // namespace finemote::gen
