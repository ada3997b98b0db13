// The cases of this folder, and what the model says of a text.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::test {

/// `FM3012_unknown_port.urdf`, or a folder `FM3101_malformed` with `robot.urdf`, `devices/` and `boards/`.
struct Case {
  std::string name;  ///< without suffix
  std::filesystem::path input;
  std::filesystem::path folder;
  std::filesystem::path expected;
  std::string display;
};

/// The root of the source tree, and this folder in it.
std::filesystem::path source_folder();
std::filesystem::path cases_folder();

std::set<std::string> case_names();
Case find_case(const std::string& name);

/// What is said of `text` as the robot of the case; it is read from the case's file when `text` is empty.
struct Said {
  gen::Sources sources;
  gen::Diagnostics diagnostics;
};
void examine(const Case& test, const std::string& text, Said& said);

}  // namespace finemote::test
