// finemote init: a project around a robot, which builds at once.
#include <fmt/format.h>

#include <memory>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/new_project.hpp"
#include "generator/cli/settings.hpp"
#include "generator/cli/shell_word.hpp"
#include "generator/scaffold/new_files.hpp"

namespace finemote::gen {
namespace {

/// --from and --example name a robot that says everything itself. The project builds firmware for a chip.
bool is_usable(const Options& options, Diagnostics& diagnostics) {
  if (options.board == "host") {
    diagnostics.error(code::usage, {}, "board 'host' is this computer, and the project builds firmware for a chip")
        .hint(
            "name the robot's board; finemote_add_firmware(... BOARD host) builds its sources for this computer, too");
    return false;
  }
  const bool has_robot = !(options.from + options.example).empty();
  if (options.arguments.empty() && !(has_robot && !options.board.empty())) return true;
  diagnostics.error(code::usage, {}, "init takes no name:=value, and --board only for the robot that it writes itself")
      .hint("set them in the file of your robot");
  return false;
}

/// Writes the generated sources of the project; `check` and `run` of the project say what they can say against them.
bool generate_sources(const Options& options, const NewProject& project, const std::string& data_dir, Sources& sources,
                      Diagnostics& diagnostics) {
  Options generate;
  generate.input = options.input + "/src/" + project.robot_file;
  generate.out = options.input + "/generated";
  generate.data_dir = data_dir;
  generate.allow_unschedulable = true;
  return run_generate(settings_of(generate, sources, diagnostics).options, sources, diagnostics).status == kExitYes;
}

std::vector<std::string> names_of(const NewProject& project) {
  std::vector<std::string> names;
  for (const OutputFile& file : project.files) names.push_back(file.name);
  names.insert(names.end(), project.generated.begin(), project.generated.end());
  return names;
}

Answer answer_of(const Options& options, const NewProject& project) {
  Answer answer{kExitYes};
  for (const std::string& name : names_of(project)) answer.text += name + "\n";
  answer.text += fmt::format(
      "\nNext, for example:\n  cd {}\n  finemote run src/{}\n"
      "  cmake --preset firmware && cmake --build --preset firmware\n",
      shell_word(options.input), project.robot_file);
  answer.document = {{"schema", "finemote.init/1"}, {"output", options.input}, {"written", names_of(project)}};
  return answer;
}

}  // namespace

Answer run_init(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  if (!is_usable(options, diagnostics)) return no_answer();
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  const auto project = plan_project(options, data_dir, sources, diagnostics);
  if (!project || !are_new(options.input, names_of(*project), diagnostics)) return no_answer();
  if (!write_new(options.input, project->files, diagnostics)) return no_answer();
  const auto generated = std::make_shared<Sources>();
  const bool is_generated = generate_sources(options, *project, data_dir, *generated, diagnostics);
  Answer answer = is_generated ? answer_of(options, *project) : no_answer();
  answer.sources = generated;
  return answer;
}

}  // namespace finemote::gen
