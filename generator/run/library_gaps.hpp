// What has no bound in functions of the compiler's libraries, told where the robot's code calls them.
#pragma once

#include <vector>

#include "generator/image/source_lines.hpp"
#include "generator/run/source_names.hpp"
#include "generator/wcet/image_times.hpp"

namespace finemote::gen {

/// Gaps in the same order; of several in one function of a library, called at one place, the first. Nobody can mark a
/// loop there, so that the call is what has to change.
std::vector<wcet::TimeGap> blame_callers_of_libraries(const std::vector<wcet::TimeGap>& gaps, const SourceLines& lines,
                                                      const SourceNames& names);

}  // namespace finemote::gen
