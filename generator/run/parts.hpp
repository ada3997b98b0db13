// A robot to the parts that hang on the emulated board's buses.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A `finemote.scenario/1` document (docs/reference/emulator.md) with every part of the robot the emulator has a model
/// of, named like its device or expander. Devices without a model stay silent on the wire.
nlohmann::ordered_json emulated_parts(const Robot& robot);

}  // namespace finemote::gen
