// finemote scaffold: the first lines of a device type or of a board file.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/descriptor/cpp_words.hpp"
#include "generator/scaffold/fill_folder.hpp"
#include "generator/scaffold/names.hpp"
#include "generator/scaffold/new_files.hpp"

namespace finemote::gen {
namespace {

/// Where the files go without -o: `src` of a project that init wrote, else here.
std::string usual_folder() { return std::filesystem::is_directory("src/devices") ? "src" : "."; }

/// The name of a device type is that of a namespace, too, in the header that is written for it.
std::optional<std::string> why_no_namespace(const std::string& name) {
  if (name == "finemote" || name == "std") return "is the namespace of others";
  return invalid_name(name);
}

/// Whether the data folder has a descriptor or a board file of this name.
bool is_shipped_name(const std::string& data_dir, const std::string& what, const std::string& name) {
  const auto has = [&](const std::string& folder) {
    return std::filesystem::exists(std::filesystem::path(data_dir) / "schemas" / folder / (name + ".json"));
  };
  return what == "board" ? has("boards") || has("chips") : has("devices") || has("expanders");
}

/// Reports why NAME cannot be one.
bool is_free_name(const std::string& data_dir, const std::string& what, const std::string& name,
                  Diagnostics& diagnostics) {
  const std::string refusal = fmt::format("a {} cannot be called '{}'", what, name);
  if (!is_type_name(name)) {
    diagnostics.error(code::usage, {}, refusal)
        .hint("begin with a lower-case letter; then lower-case letters, digits and '_'");
    return false;
  }
  const auto fault = what == "device" ? why_no_namespace(name) : std::nullopt;
  const bool is_shipped = is_shipped_name(data_dir, what, name);
  if (!fault && !is_shipped) return true;
  diagnostics.error(code::usage, {}, fmt::format("{}, which {}", refusal, fault ? *fault : "comes with finemote"))
      .hint(fmt::format("give it a name of its own, for example 'my_{}'", name));
  return false;
}

/// The templates below templates/scaffold/`what`, filled for NAME.
Answer scaffold(const std::string& what, const std::string& next, const Options& options, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty() || !is_free_name(data_dir, what, options.input, diagnostics)) return no_answer();
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
