// finemote.json beside a robot, to the options that are not given on the command line.
#pragma once

#include <string>
#include <vector>

#include "generator/cli/answer.hpp"
#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

inline constexpr const char* kSettingsName = "finemote.json";

struct Setting {
  std::string name;   ///< `board`, or `arguments.period`
  std::string value;  ///< empty: none
  std::string from;   ///< `command line`, `finemote.json:3`, or `default`
};

struct Settings {
  Options options;            ///< of the command line, and where it says nothing those of the file
  std::vector<Setting> list;  ///< all there are, in the order of the reference
};

/// The settings for the robot options.input. A file that is read becomes one of the sources. Reports FM0011 for what
/// the file cannot set, and for folders that are not in its own; FM4001 and FM4002 where it is no JSON.
Settings settings_of(const Options& options, Sources& sources, Diagnostics& diagnostics);

/// What --show-config prints.
Answer settings_answer(const Settings& settings);

}  // namespace finemote::gen
