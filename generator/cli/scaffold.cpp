// finemote scaffold: the first lines of a device type or of a board file.
#include <fmt/format.h>

#include <filesystem>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/scaffold/fill_folder.hpp"
#include "generator/scaffold/names.hpp"
#include "generator/scaffold/new_files.hpp"

namespace finemote::gen {
namespace {

/// Where the files go without -o: `src` of a project that init wrote, else here.
std::string usual_folder() { return std::filesystem::is_directory("src/devices") ? "src" : "."; }

/// The templates below templates/scaffold/`what`, filled for NAME.
Answer scaffold(const std::string& what, const std::string& next, const Options& options, Diagnostics& diagnostics) {
  if (!is_type_name(options.input)) {
    diagnostics.error(code::usage, {}, fmt::format("a {} cannot be called '{}'", what, options.input))
        .hint("begin with a lower-case letter; then lower-case letters, digits and '_'");
    return no_answer();
  }
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  const std::vector<OutputFile> files = fill_folder(data_dir + "/templates/scaffold/" + what,
                                                    {{"name", options.input}, {"class", camel_case(options.input)}});
  const std::string folder = options.out.empty() ? usual_folder() : options.out;
  std::vector<std::string> names, paths;
  for (const OutputFile& file : files) {
    names.push_back(file.name);
    paths.push_back((std::filesystem::path(folder) / file.name).lexically_normal().generic_string());
  }
  if (!are_new(folder, names, diagnostics) || !write_new(folder, files, diagnostics)) return no_answer();
  Answer answer{kExitYes};
  for (const std::string& path : paths) answer.text += path + "\n";
  answer.text += next;
  answer.document = {{"schema", "finemote.scaffold/1"}, {"written", paths}};
  return answer;
}

}  // namespace

Answer run_scaffold_device(const Options& options, Sources&, Diagnostics& diagnostics) {
  return scaffold("device",
                  fmt::format("\nIn the robot: <device name=\"{0}\" type=\"{0}\" period=\"10ms\"/>\n", options.input),
                  options, diagnostics);
}

Answer run_scaffold_board(const Options& options, Sources&, Diagnostics& diagnostics) {
  return scaffold("board", "\nWhat next: docs/howto/add-a-board.md\n", options, diagnostics);
}

}  // namespace finemote::gen
