// Completion for bash and zsh: two functions around the same cases.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/cli/commands.hpp"
#include "generator/cli/completion.hpp"
#include "generator/cli/shell_word.hpp"

namespace finemote::gen {
namespace {

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

/// How a shell offers things: an array of words that is filled, and what fills it.
struct Shell {
  const char* words;  ///< offers the words of a text: `offer 'a b'`
  const char* files;  ///< offers files
};

/// The cases of the words that are part of a command: `' board' | 'board show'`.
std::string command_patterns() {
  std::vector<std::string> patterns;
  for (const CommandPath& path : command_paths()) patterns.push_back(quoted_for_shell(path.before + " " + path.word));
  return joined(patterns, " | ");
}

/// What is offered for the value of an option or for an operand.
std::string offer_value(const Shell& shell, const Option& option) {
  const std::vector<std::string> values = values_of(option);
  if (!values.empty()) return fmt::format("{} {}", shell.words, quoted_for_shell(joined(values, " ")));
  if (option.listed_by != nullptr) return fmt::format("{} \"$({})\"", shell.words, listing_command(option));
  return shell.files;
}

/// The cases of a `case` command: what is offered, and the patterns it is offered for.
using Cases = std::map<std::string, std::vector<std::string>>;

/// Lines `PATTERN | PATTERN) OFFER ;;`.
std::string lines_of(const Cases& cases, const char* end) {
  std::string text;
  for (const auto& [offer, patterns] : cases)
    text += fmt::format("    {}) {}{} ;;\n", joined(patterns, " | "), offer, end);
  return text;
}

/// Of `case "$command $before"`; a command's own option comes before one of all commands that has its name.
std::string value_cases(const Shell& shell) {
  Cases own, common;
  const auto add = [&](const std::string& command, const Option& option, Cases& cases) {
    if (is_operand(option) || !takes_value(option)) return;
    for (const std::string& name : names_of(option)) cases[offer_value(shell, option)].push_back(command + name);
  };
  for (const Option& option : common_options()) add("*' '", option, common);
  for (const Command& command : commands()) {
    for (const Option& option : command.options) add(quoted_for_shell(std::string(command.name) + " "), option, own);
  }
  return lines_of(own, "; return") + lines_of(common, "; return");
}

/// The names of options, each once.
std::string option_words(const std::vector<const std::vector<Option>*>& tables, std::vector<std::string> words) {
  for (const std::vector<Option>* table : tables) {
    for (const Option& option : *table) {
      for (const std::string& name : names_of(option)) {
        const bool is_new = std::find(words.begin(), words.end(), name) == words.end();
        if (!is_operand(option) && is_new) words.push_back(name);
      }
    }
  }
  return joined(words, " ");
}

/// Lines of `case "$command"` for a word that begins with a dash.
std::string option_cases(const Shell& shell) {
  std::string text;
  for (const Command& command : commands()) {
    text += fmt::format("      {}) {} {} ;;\n", quoted_for_shell(command.name), shell.words,
                        quoted_for_shell(option_words({&command.options, &common_options()}, {"-h", "--help"})));
  }
  return text + fmt::format("      *) {} {} ;;\n", shell.words,
                            quoted_for_shell(option_words({&common_options()}, {"-h", "--help", "--version"})));
}

/// Of `case "$command"` for all other words: further words of the command, or its operands.
std::string operand_cases(const Shell& shell) {
  std::map<std::string, std::vector<std::string>> below;
  for (const CommandPath& path : command_paths()) below[path.before].push_back(path.word);
  Cases cases;
  for (const auto& [before, words] : below)
    cases[fmt::format("{} {}", shell.words, quoted_for_shell(joined(words, " ")))].push_back(quoted_for_shell(before));
  for (const Command& command : commands()) {
    if (command.options.empty() || !is_operand(command.options.front())) continue;
    cases[offer_value(shell, command.options.front())].push_back(quoted_for_shell(command.name));
  }
  return lines_of(cases, "");
}

/// From the words so far ($@), the word that is completed ($word) and the one before it ($before) to what is offered.
std::string body(const Shell& shell) {
  return "  local command= given\n"
         "  for given; do\n"
         "    case \"$command $given\" in\n"
         "      " +
         command_patterns() +
         ") command=${command:+$command }$given ;;\n"
         "    esac\n"
         "  done\n"
         "  case \"$command $before\" in\n" +
         value_cases(shell) +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    case \"$command\" in\n" +
         option_cases(shell) +
         "    esac\n"
         "    return\n"
         "  fi\n"
         "  case \"$command\" in\n" +
         operand_cases(shell) + "  esac\n";
}

}  // namespace

std::string bash_completion() {
  constexpr Shell kBash{"_finemote_words", "_finemote_files"};
  return "# Completion of finemote for bash, made by `finemote completion bash`.\n"
         "\n"
         "_finemote_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\"); }\n"
         "\n"
         "_finemote_files() {\n"
         "  compopt -o filenames 2>/dev/null\n"
         "  mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
         "}\n"
         "\n"
         "_finemote_offer() {\n" +
         body(kBash) +
         "}\n"
         "\n"
         "_finemote() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  COMPREPLY=()\n"
         "  if [[ $word == = ]]; then\n"
         "    word=\n"
         "  elif [[ $before == = ]]; then\n"
         "    before=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  _finemote_offer \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"\n"
         "}\n"
         "\n"
         "complete -F _finemote finemote\n";
}

std::string zsh_completion() {
  constexpr Shell kZsh{"_finemote_words", "_files"};
  return "#compdef finemote\n"
         "# Completion of finemote for zsh, made by `finemote completion zsh`.\n"
         "\n"
         "_finemote_words() { compadd -- ${=1}; }\n"
         "\n"
         "_finemote_offer() {\n" +
         body(kZsh) +
         "}\n"
         "\n"
         "_finemote() {\n"
         "  local word=$PREFIX before=$words[CURRENT-1]\n"
         "  if [[ $word == --*=* ]]; then\n"
         "    before=${word%%=*}\n"
         "    compset -P 1 '*='\n"
         "    word=$PREFIX\n"
         "  fi\n"
         "  _finemote_offer \"${(@)words[2,CURRENT-1]}\"\n"
         "}\n"
         "\n"
         "# Called by the completion that loads this file as a function, or read by `source`.\n"
         "if [[ $funcstack[1] == _finemote ]]; then _finemote \"$@\"; else compdef _finemote finemote; fi\n";
}

}  // namespace finemote::gen
