// The words of the command line to options, as the table of commands defines them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/command_words.hpp"
#include "generator/cli/options.hpp"

namespace finemote::gen {

/// What the words ask for: a command to run, or a text to print and stop (help, version, or a usage error).
struct ParsedCommandLine {
  std::optional<Options> options;
  int exit_status = 0;
  std::string text;      ///< for stdout when the status is 0, else for stderr
  std::string findings;  ///< for stdout when it is not: the same in the format that was asked for, sarif, github or gcc
};

/// Options may stand before or after the command, `name:=value` anywhere. Words that mean nothing are a usage error
/// (FM0001) even beside --help and --version.
ParsedCommandLine parse_command_line(const std::vector<std::string>& words);

/// Every command and option there is, for the test of the page that describes them.
CommandWords command_line_words();

}  // namespace finemote::gen
