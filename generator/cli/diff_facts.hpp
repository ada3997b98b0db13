// A robot to the facts that `finemote diff` compares: all that an answer or an output of some command is made from.
#pragma once

#include <map>
#include <string>

#include "generator/pipeline.hpp"

namespace finemote::gen {

/// By property (`period`), as text for people.
using Properties = std::map<std::string, std::string>;

/// By subject (`device 'imu'`).
using Facts = std::map<std::string, Properties>;

Facts facts_of(const PlannedRobot& planned);

}  // namespace finemote::gen
