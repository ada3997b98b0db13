// The longest way through a stage or a routine, line by line: `finemote wcet --explain`.
#pragma once

#include <optional>
#include <string>

#include "generator/run/wcet_report.hpp"

namespace finemote::gen {

/// Piece by piece, then the lines on which most of the time goes.
/// @param name  as a row of wcet_text(); none: there is no such row
std::optional<std::string> explain_longest_way(const TimedRobot& timed, const std::string& name);

}  // namespace finemote::gen
