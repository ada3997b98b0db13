#include "generator/cli/command_words.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

/// The command directly below this one; null when there is none of the name.
const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const auto commands = app.get_subcommands({});
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const CLI::App* command) { return command->get_name() == name; });
  return found == commands.end() ? nullptr : *found;
}

/// An option of this command or of one below it, by a name of it with its dashes.
const CLI::Option* find_option(const CLI::App& app, const std::string& name) {
  if (const CLI::Option* option = app.get_option_no_throw(name)) return option;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (const CLI::Option* option = find_option(*command, name)) return option;
  }
  return nullptr;
}

/// Whether the next word is the option's value. Of an unknown option: whether the next word can be nothing else.
bool takes_next_word(const CLI::App& app, const std::vector<std::string>& words, std::size_t option) {
  if (words[option].find('=') != std::string::npos || option + 1 == words.size()) return false;
  const CLI::Option* known = find_option(app, words[option]);
  if (known != nullptr) return known->get_items_expected_max() > 0;
  return !is_option(words[option + 1]) && find_command(app, words[option + 1]) == nullptr;
}

/// The first word from `begin` on that is neither an option nor the value of one; the number of words without one.
std::size_t operand(const CLI::App& app, const std::vector<std::string>& words, std::size_t begin) {
  while (begin < words.size() && is_option(words[begin])) begin += takes_next_word(app, words, begin) ? 2 : 1;
  return std::min(begin, words.size());
}

/// The command the words chose, or the program itself.
const CLI::App& deepest(const CLI::App& app) {
  const CLI::App* level = &app;
  while (!level->get_subcommands().empty()) level = level->get_subcommands().front();
  return *level;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* level : {&deepest(app), &app}) {
    for (const CLI::Option* option : level->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
  }
  return names;
}

struct UsageMistake {
  std::string message;
  std::string hint;
};

/// Words that no option and no operand takes: the first option among them, else the first of them.
UsageMistake describe_extra(const CLI::App& app, const std::vector<std::string>& words) {
  const std::vector<std::string> extra = app.remaining(true);
  const std::string help = "finemote " + chosen_command(app) + " --help";
  const auto is_extra = [&](const std::string& w) { return std::find(extra.begin(), extra.end(), w) != extra.end(); };
  const auto option = std::find_if(words.begin(), words.end(),
                                   [&](const std::string& w) { return !w.empty() && w.front() == '-' && is_extra(w); });
  if (option != words.end()) {
    const std::string name = option->substr(0, option->find('='));
    const auto near = near_hint(name, option_names(app));
    return {"command '" + chosen_command(app) + "' has no option '" + name + "'", near.empty() ? help : near.front()};
  }
  const auto word = std::find_if(words.begin(), words.end(), is_extra);
  return {"unexpected argument '" + (word == words.end() ? std::string() : *word) + "'", help};
}

/// What CLI11 says, with the command it is about, in the manner of our own messages.
UsageMistake describe_other(const CLI::App& app, const CLI::ParseError& error) {
  std::string reason = error.what();
  const std::string command = chosen_command(app);
  const bool begins_with_word = reason.size() > 1 && std::islower(static_cast<unsigned char>(reason[1])) != 0;
  if (begins_with_word) reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
  if (command.empty()) return {reason, "finemote --help"};
  return {"command '" + command + "': " + reason, "finemote " + command + " --help"};
}

/// No command was chosen, or only the first of its two words.
UsageMistake describe_missing_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App& level = deepest(app);
  const std::string chosen = chosen_command(app);
  std::vector<std::string> commands;
  for (const CLI::App* command : level.get_subcommands({})) {
    commands.push_back((chosen.empty() ? "" : chosen + " ") + command->get_name());
  }
  const std::size_t at = operand(app, words, chosen.empty() ? 0 : 1);
  if (at == words.size()) {
    const std::string message =
        chosen.empty() ? "a command is missing" : "command '" + chosen + "' needs a second word";
    return {message, chosen.empty() ? "finemote --help" : did_you_mean("", commands)};
  }
  const std::string asked = (chosen.empty() ? "" : chosen + " ") + words[at];
  return {"there is no command '" + asked + "'", did_you_mean(asked, commands)};
}

UsageMistake describe_mistake(const CLI::App& app, const std::vector<std::string>& words,
                              const CLI::ParseError& error) {
  if (!deepest(app).get_subcommands({}).empty()) return describe_missing_command(app, words);
  if (!app.remaining(true).empty()) return describe_extra(app, words);
  return describe_other(app, error);
}

}  // namespace

std::string chosen_command(const CLI::App& app) {
  std::string name;
  for (const CLI::App* level = &app; !level->get_subcommands().empty(); level = level->get_subcommands().front()) {
    name += (name.empty() ? "" : " ") + level->get_subcommands().front()->get_name();
  }
  return name;
}

std::vector<std::string> take_arguments(const std::vector<std::string>& words,
                                        std::vector<std::pair<std::string, std::string>>& arguments) {
  std::vector<std::string> rest;
  for (const std::string& word : words) {
    const auto at = word.find(":=");
    const bool is_argument = at != std::string::npos && at > 0 && word.front() != '-';
    if (is_argument) {
      arguments.emplace_back(word.substr(0, at), word.substr(at + 2));
    } else {
      rest.push_back(word);
    }
  }
  return rest;
}

std::vector<std::string> command_first(const CLI::App& app, std::vector<std::string> words) {
  std::size_t begin = 0;
  for (const CLI::App* level = &app; level != nullptr && !level->get_subcommands({}).empty(); ++begin) {
    const std::size_t at = operand(app, words, begin);
    if (at == words.size()) return words;
    level = find_command(*level, words[at]);
    if (level == nullptr) return words;
    std::rotate(words.begin() + begin, words.begin() + at, words.begin() + at + 1);
  }
  return words;
}

/// The message for wrong words, in the form of all others.
Diagnostics usage_error(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error) {
  const UsageMistake mistake = describe_mistake(app, words, error);
  Diagnostics diagnostics;
  diagnostics.error(code::usage, {}, mistake.message).hint(mistake.hint);
  return diagnostics;
}

CommandWords words_of(const CLI::App& app) {
  CommandWords words;
  words.name = app.get_name();
  for (const CLI::Option* option : app.get_options()) {
    if (option == app.get_help_ptr()) continue;
    if (option->get_positional()) {
      words.operands.push_back(option->get_name(true));
      continue;
    }
    OptionWords& found = words.options.emplace_back();
    for (const std::string& name : option->get_snames()) found.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) found.names.push_back("--" + name);
    std::istringstream choices(option->get_option_text());
    for (std::string choice; std::getline(choices, choice, '|');) found.choices.push_back(choice);
  }
  for (const CLI::App* command : app.get_subcommands({})) words.commands.push_back(words_of(*command));
  return words;
}

}  // namespace finemote::gen
