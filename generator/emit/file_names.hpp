// Names of the generated files, as seen from their folder.
#pragma once

#include <string>

#include "generator/forest/forest.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Files that every robot has; each is made from the template of its name with `.mustache` behind it.
inline constexpr const char* kFixedFiles[] = {"schedule.hpp", "schedule.cpp", "buses.hpp", "buses.cpp",
                                              "constants.hpp"};

inline std::string tree_header_name(const Tree& tree) { return "trees/" + tree.space + ".hpp"; }
inline std::string tree_source_name(const Tree& tree) { return "trees/" + tree.space + ".cpp"; }

/// What a computer that talks to this device includes.
inline std::string link_header_name(const Device& device) { return "host/" + device.name.cpp + "_link.hpp"; }

}  // namespace finemote::gen
