// Completion for fish: a line for each word, with what --help says of it.
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/completion.hpp"
#include "generator/cli/shell_word.hpp"

namespace finemote::gen {
namespace {

/// The beginning of a line about what may follow a command: `complete -c finemote -n '__finemote_is board'`.
std::string line_after(const std::string& command) {
  return fmt::format("complete -c finemote -n {}", quoted_for_shell("__finemote_is " + command));
}

/// `-s o -l output`.
std::string names_text(const Option& option) {
  std::string text;
  for (const std::string& name : names_of(option))
    text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text;
}

/// What may stand for a value or an operand; without `-f` and `-x` a file may.
std::string values_text(const Option& option, const char* no_files) {
  std::string words;
  for (const std::string& value : values_of(option)) words += (words.empty() ? "" : " ") + value;
  if (option.listed_by != nullptr) words = "(" + listing_command(option) + ")";
  return words.empty() ? std::string() : fmt::format(" {} -a {}", no_files, quoted_for_shell(words));
}

std::string option_line(const std::string& beginning, const Option& option) {
  std::string line = beginning + names_text(option);
  if (takes_value(option)) line += " -r" + values_text(option, "-f");
  return fmt::format("{} -d {}\n", line, quoted_for_shell(option.help));
}

std::string command_lines(const Command& command) {
  const std::string beginning = line_after(command.name);
  std::string text;
  for (const Option& option : command.options) {
    if (!is_operand(option)) {
      text += option_line(beginning, option);
    } else if (const std::string values = values_text(option, "-f"); !values.empty()) {
      text += beginning + values + "\n";
    }
  }
  return text;
}

}  // namespace

std::string fish_completion() {
  std::string cases;
  std::string words;
  for (const CommandPath& path : command_paths()) {
    cases += " " + quoted_for_shell(path.before + " " + path.word);
    words += fmt::format("{} -f -a {} -d {}\n", line_after(path.before), path.word, quoted_for_shell(path.summary));
  }
  std::string text =
      "# Completion of finemote for fish, made by `finemote completion fish`.\n"
      "\n"
      "function __finemote_is --description 'whether these are the words of the command so far'\n"
      "    set -l command ''\n"
      "    for word in (commandline -opc)[2..-1]\n"
      "        switch \"$command $word\"\n"
      "            case" +
      cases +
      "\n"
      "                set command (string trim -- \"$command $word\")\n"
      "        end\n"
      "    end\n"
      "    test \"$command\" = \"$argv\"\n"
      "end\n"
      "\n" +
      words;
  text += "complete -c finemote -s h -l help -d 'print help'\n" + line_after("") + " -l version -d 'print versions'\n";
  for (const Option& option : common_options()) text += option_line("complete -c finemote", option);
  for (const Command& command : commands()) text += command_lines(command);
  return text;
}

}  // namespace finemote::gen
