// Names of the URDF to C++ names, and what a name may not be.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Every character outside [A-Za-z0-9_] becomes `_` (one per byte), a leading digit gets `n_` before it.
std::string cpp_name(std::string_view text);

inline Name make_name(std::string_view text) { return {std::string(text), cpp_name(text)}; }

/// Where a name is used in generated code; each place has names of its own.
enum class NameScope {
  robot,      ///< the outermost namespace, beside the C library
  in_robot,   ///< buses, expanders and tree namespaces
  file,       ///< roots and robots, after which files are named
  tree_file,  ///< roots: their files stand beside each other and include those of the robot
  in_tree,    ///< devices
};

/// Why generated code does not leave the name free in that place.
std::optional<std::string> reserved_name(std::string_view cpp, NameScope scope);

/// The same text with letters in lower case: names that differ by case only clash (files, readers).
std::string fold_case(std::string_view text);

}  // namespace finemote::gen
