// A robot to the facts that `finemote diff` compares: all that an answer or an output of some command is made from.
#pragma once

#include <map>
#include <string>

#include "generator/pipeline.hpp"

namespace finemote::gen {

/// By subject (`device 'imu'`) and property (`period`), as text for people.
using Facts = std::map<std::string, std::map<std::string, std::string>>;

Facts facts_of(const PlannedRobot& planned);

}  // namespace finemote::gen
