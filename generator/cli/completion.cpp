// finemote completion: what completes the words of a command line, for a shell.
#include "generator/cli/completion.hpp"

#include <set>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"

namespace finemote::gen {

std::vector<CommandPath> command_paths() {
  std::vector<CommandPath> paths;
  std::set<std::string> groups;
  for (const Command& command : commands()) {
    const std::string name = command.name;
    const auto blank = name.find(' ');
    const std::string first = name.substr(0, blank);
    if (blank == std::string::npos) {
      paths.push_back({"", name, command.summary});
      continue;
    }
    if (groups.insert(first).second) paths.push_back({"", first, group_summary(first)});
    paths.push_back({first, name.substr(blank + 1), command.summary});
  }
  return paths;
}

std::string listing_command(const Option& option) {
  return std::string("finemote ") + option.listed_by + " 2>/dev/null | cut -d ' ' -f 1";
}

Answer run_completion(const Options& options, Sources& /*sources*/, Diagnostics& /*diagnostics*/) {
  std::string (*const kCompletions[])() = {bash_completion, zsh_completion, fish_completion};
  for (std::size_t shell = 0; shell < std::size(kShellWords); ++shell) {
    if (options.input == kShellWords[shell]) return {kExitYes, kCompletions[shell]()};
  }
  return no_answer();  // the command line takes no other word
}

}  // namespace finemote::gen
