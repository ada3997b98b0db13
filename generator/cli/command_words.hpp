// The words of a command line beside its definition: their order, what is wrong with them, and what words there are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace finemote::gen {

struct OptionWords {
  std::vector<std::string> names;    ///< with their dashes, short ones first
  std::vector<std::string> choices;  ///< the possible values, where there are few; else empty
};

/// A command (or the program itself): what may follow it on the command line.
struct CommandWords {
  std::string name;
  std::vector<std::string> operands;
  std::vector<OptionWords> options;  ///< its own, without --help
  std::vector<CommandWords> commands;
};

/// Every word of the definition.
CommandWords words_of(const CLI::App& app);

/// Takes every `name:=value` out of the words: they may stand anywhere and are meant for xacro.
std::vector<std::string> take_arguments(const std::vector<std::string>& words,
                                        std::vector<std::pair<std::string, std::string>>& arguments);

/// The words with the command (`board show`: both) before all others: an option before the command is as good as one
/// after it. Unchanged where no command is found.
std::vector<std::string> command_first(const CLI::App& app, std::vector<std::string> words);

/// The command the last parse chose, `board show` for one of two words; empty when there is none.
std::string chosen_command(const CLI::App& app);

/// What is wrong with the words. `words` as they were parsed, the command first.
Diagnostics usage_error(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error);

}  // namespace finemote::gen
