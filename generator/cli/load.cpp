#include "generator/cli/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/cli/data_dir.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/build.hpp"
#include "generator/output/folder.hpp"
#include "generator/output/sha256.hpp"
#include "generator/xacro/command.hpp"
#include "generator/xacro/expand.hpp"
#include "generator/xacro/packages.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::string base_name(const std::string& input) { return input == "-" ? "stdin" : fs::path(input).filename().string(); }

fs::path input_folder(const std::string& input) {
  if (input == "-") return fs::current_path();
  const fs::path parent = fs::path(input).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

/// `name=dir` words, the environment, and the package IN lies in. Reports words of another form.
xacro::PackagePath package_path(Context& context) {
  const bool is_sandbox = context.sources.access().is_sandbox();
  xacro::PackagePath packages = is_sandbox ? xacro::PackagePath() : xacro::PackagePath::from_environment();
  for (const auto& [name, folder] : package_folders(context)) packages.add(name, folder);
  packages.set_entry(context.options.input);
  return packages;
}

bool is_xacro(const std::string& input) { return fs::path(input).extension() == ".xacro"; }

/// Arguments mean something to xacro alone; to forget that silently would be worse than an error.
bool refuse_arguments(Context& context) {
  const auto& arguments = context.options.arguments;
  if (arguments.empty()) return false;
  const auto& [name, value] = arguments.front();
  context.diagnostics
      .error(code::usage, {},
             fmt::format("'{}:={}' is for xacro, and '{}' is not read as xacro", name, value, context.options.input))
      .hint("give the file the suffix .xacro");
  return true;
}

std::optional<xml::Document> read_document(Context& context, const std::string* edited) {
  const std::string& input = context.options.input;
  if (!is_xacro(input) && refuse_arguments(context)) return std::nullopt;
  if (fs::path(input).extension() == ".json") {
    context.diagnostics.error(code::usage, {}, fmt::format("'{}' is a timing model; this command needs a robot", input))
        .hint("analyze, simulate and diff take models");
    return std::nullopt;
  }
  const SourceFile* file = edited != nullptr ? context.sources.add({input, input, *edited})
                                             : xml::read_source(input, context.sources, context.diagnostics);
  if (file == nullptr) return std::nullopt;
  if (!is_xacro(input)) return xml::parse(*file, context.diagnostics);
  xacro::Dependencies dependencies;
  return xacro::expand(*file, xacro_arguments(context.options), package_path(context), context.sources,
                       context.diagnostics, dependencies, &context.err);
}

/// The nearest folder at or above `folder` that is a ROS package; empty when there is none.
fs::path package_of(fs::path folder) {
  for (; !folder.empty() && folder != folder.root_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / "package.xml")) return folder;
  }
  return {};
}

std::string manifest_name(const fs::path& path, const fs::path& input_dir, const fs::path& data_dir) {
  const fs::path file = fs::weakly_canonical(path);
  const auto inside = [&](const fs::path& folder) -> std::string {
    const std::string relative = file.lexically_relative(fs::weakly_canonical(folder)).generic_string();
    return relative.empty() || relative.rfind("..", 0) == 0 ? std::string() : relative;
  };
  const std::string builtin = inside(data_dir / "schemas");
  if (!builtin.empty()) return "builtin:" + builtin;
  const std::string near = inside(input_dir);
  if (!near.empty()) return near;
  const fs::path package = package_of(file.parent_path());
  if (package.empty()) return file.lexically_relative(fs::weakly_canonical(input_dir)).generic_string();
  return "package://" + package.filename().string() + "/" + file.lexically_relative(package).generic_string();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> package_folders(Context& context) {
  std::vector<std::pair<std::string, std::string>> folders;
  for (const std::string& word : context.options.packages) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      context.diagnostics.error(code::usage, {}, fmt::format("--package '{}' has no name and folder", word))
          .hint("write --package name=dir");
      continue;
    }
    std::error_code failed;
    const fs::path folder = fs::absolute(word.substr(equals + 1), failed);  // as written, it would follow the file
    folders.emplace_back(word.substr(0, equals), failed ? word.substr(equals + 1) : folder.lexically_normal().string());
  }
  return folders;
}

xacro::Arguments xacro_arguments(const Options& options) {
  xacro::Arguments arguments;
  for (const auto& [name, value] : options.arguments) xacro::add_argument(name + ":=" + value, arguments);
  return arguments;
}

std::optional<Loaded> load_robot(Context& context, const std::string* edited) {
  Loaded loaded;
  loaded.data_dir = find_data_dir(context.options, context.diagnostics);
  if (loaded.data_dir.empty()) return std::nullopt;

  const auto document = read_document(context, edited);
  if (!document) return std::nullopt;
  const LibraryOptions folders{
      loaded.data_dir, input_folder(context.options.input).string(), context.options.device_paths, {}};
  auto library = load_library(folders, context.sources, context.diagnostics);
  if (!library) return std::nullopt;
  loaded.library = std::move(*library);

  ModelOptions model;
  model.board = context.options.board;
  model.from_xacro = is_xacro(context.options.input);
  auto robot = build_model(*document, loaded.library, model, context.sources, context.diagnostics);
  if (!robot || context.diagnostics.has_errors()) return std::nullopt;
  loaded.robot = std::move(*robot);
  loaded.robot.source = base_name(context.options.input);

  loaded.forest = build_forest(loaded.robot);
  loaded.schedule = plan_schedule(loaded.robot, loaded.forest, context.diagnostics);
  if (context.diagnostics.has_errors()) return std::nullopt;
  return loaded;
}

std::vector<OutputFile> render_robot(Context& context, const Loaded& loaded) {
  const ProvenBounds bounds = prove_bounds(loaded.robot, loaded.forest, loaded.schedule);
  return render_files(loaded.plan(), bounds, loaded.data_dir, context.diagnostics);
}

std::vector<HashedFile> input_files(const Context& context, const Loaded& loaded) {
  std::vector<HashedFile> files;
  const fs::path input_dir = input_folder(context.options.input);
  for (const SourceFile& file : context.sources.files()) {
    const bool is_stdin = file.path.empty() || file.path == "-";
    const auto bytes =
        is_stdin ? std::optional(file.text) : context.sources.access().read(file.path, xml::kMaxFileSize);
    files.push_back(
        {is_stdin ? "stdin" : manifest_name(file.path, input_dir, loaded.data_dir), sha256(bytes.value_or(file.text))});
  }
  std::sort(files.begin(), files.end(), [](const HashedFile& a, const HashedFile& b) { return a.name < b.name; });
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::vector<std::string> output_options(const Options& options) {
  std::vector<std::string> words;
  for (const auto& [name, value] : xacro_arguments(options)) words.push_back(name + ":=" + value);
  std::sort(words.begin(), words.end());
  if (!options.board.empty()) words.insert(words.begin(), "--board " + options.board);
  return words;
}

}  // namespace finemote::gen
