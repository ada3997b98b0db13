// The generated files of many robots as one translation unit: a compiler reads the runtime's headers once for all.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/emit/render.hpp"

namespace finemote::test {

/// One robot's files, and what a report says of it.
struct Generated {
  std::string space;  ///< its namespace: another one for every robot of a batch
  std::vector<gen::OutputFile> files;
  std::string input;  ///< the robot as text
};

/// All sources of the robots, each with its own headers in the place where it includes them; headers of the runtime
/// come first. Names with C linkage, which are the same in every robot, get the robot's number. What a missing <...>
/// include would break is not seen here: some robots are compiled file by file as well.
std::string translation_unit(const std::vector<Generated>& robots);

/// The first line with `inf` or `nan` as a word, with its file; empty: there is none.
std::string not_finite(const Generated& robot);

/// The robot's texts without its name: equal for robots that compile alike.
std::string nameless(const Generated& robot);

}  // namespace finemote::test
