// The table of commands to what completes the words of a command line in a shell.
#pragma once

#include <string>
#include <vector>

#include "generator/cli/option.hpp"

namespace finemote::gen {

/// How the commands are told apart: `board` comes before `board show`.
struct CommandPath {
  std::string before;  ///< the words so far: empty, or `board`
  std::string word;    ///< the one that follows: `board`, or `show`
  std::string summary;
};

/// Every first word and every second one, in the order of --help.
std::vector<CommandPath> command_paths();

/// Where the possible values of an option or operand come from.
std::string listing_command(const Option& option);

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace finemote::gen
