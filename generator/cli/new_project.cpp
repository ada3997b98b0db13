#include "generator/cli/new_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/bus/bus_type.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/named_board.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/settings.hpp"
#include "generator/diagnostic/code_output.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/file/inside.hpp"
#include "generator/model/firmware_inputs.hpp"
#include "generator/output/folder.hpp"
#include "generator/pipeline.hpp"
#include "generator/run/project.hpp"
#include "generator/scaffold/fill_folder.hpp"
#include "generator/scaffold/names.hpp"
#include "generator/timing_file/user_code.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
constexpr const char* kOwnRobot = "src/robot.urdf";
constexpr const char* kDefaultBoard = "robomaster_type_c";

/// `0.1.0` to `0.1`: below 1.0 every minor version stands for itself.
std::string minor_version() {
  const std::string version = kVersion;
  return version.substr(0, version.rfind('.'));
}

bool has_outputs(const Port& port) {
  return std::any_of(port.kinds.begin(), port.kinds.end(),
                     [](BusKind kind) { return bus_type(kind).channels == BusType::Channels::outputs; });
}

/// A lamp and a button of the board for the robot that init writes; FM0001 where it has none.
bool add_places(const Board& board, Keys& keys, Diagnostics& diagnostics) {
  const auto light = std::find_if(board.ports.begin(), board.ports.end(),
                                  [](const Port& port) { return has_outputs(port) && port.drives == "Light"; });
  const auto button = std::find_if(board.pins.begin(), board.pins.end(),
                                   [](const NamedPin& pin) { return pin.name == "key" && pin.can("input"); });
  if (light == board.ports.end() || button == board.pins.end()) {
    diagnostics
        .error(code::usage, {}, fmt::format("board '{}' has no LED and key for the robot that init writes", board.name))
        .hint("give a robot of yours with --from");
    return false;
  }
  keys["light_port"] = light->name;
  keys["button_pin"] = button->name;
  return true;
}

/// The templates, and what is copied beside them.
std::vector<OutputFile> common_files(const std::string& data_dir, const Keys& keys, Diagnostics& diagnostics) {
  std::vector<OutputFile> files = fill_folder(data_dir + "/templates/project", keys);
  const std::pair<const char*, const char*> copies[] = {
      {"cmake/toolchain-arm-none-eabi.cmake", "cmake/toolchain-arm-none-eabi.cmake"},
      {"schemas/finemote.xsd", ".vscode/finemote.xsd"},
      {"schemas/device.schema.json", ".vscode/device.schema.json"},
      {"schemas/settings.schema.json", ".vscode/settings.schema.json"}};
  for (const auto& [from, to] : copies) {
    const auto text = read_data_file(data_dir + "/" + from, diagnostics);
    if (text) files.push_back({to, *text});
  }
  return files;
}

/// Where a file is below a folder; empty: it is not.
std::string place_below(const std::string& path, const std::string& folder) {
  const auto place = inside(fs::absolute(path).lexically_normal(), fs::absolute(folder).lexically_normal());
  return place ? place->generic_string() : std::string();
}

/// Files that were read and are not shipped, what stands beside the robot's own descriptors, and what that includes.
std::vector<std::string> paths_of_robot(const std::string& data_dir, const Robot& robot, const Sources& sources) {
  std::vector<std::string> paths;
  for (const SourceFile& file : sources.files()) {
    if (!file.path.empty() && place_below(file.path, data_dir + "/schemas").empty()) paths.push_back(file.path);
  }
  for (const std::string& dir : user_include_dirs(robot)) {
    for (const auto& entry : fs::directory_iterator(dir)) {
      if (entry.is_regular_file()) paths.push_back(entry.path().generic_string());
    }
  }
  for (std::string& path : user_files(robot, sources.access())) paths.push_back(std::move(path));
  return paths;
}

/// Adds `more` where no file of the name is there.
void add_new(std::vector<OutputFile>& files, std::vector<OutputFile> more) {
  for (OutputFile& file : more) {
    const bool is_there =
        std::any_of(files.begin(), files.end(), [&](const OutputFile& other) { return other.name == file.name; });
    if (!is_there) files.push_back(std::move(file));
  }
}

/// The robot's files as those of the project; FM5016 for each that is not below the folder of the robot.
std::vector<OutputFile> files_of_robot(const Input& input, const Robot& robot, const Sources& sources,
                                       Diagnostics& diagnostics) {
  std::vector<OutputFile> files;
  for (const std::string& path : paths_of_robot(input.data_dir, robot, sources)) {
    const std::string inside = place_below(path, input_folder(input.path));
    const auto text = read_bytes(path);
    if (!inside.empty() && text) {
      add_new(files, {{"src/" + inside, *text}});
      continue;
    }
    diagnostics
        .error(code::robot_not_whole, {}, fmt::format("the robot needs '{}', which is not below its folder", path))
        .hint("move it below the folder of the robot");
  }
  return files;
}

/// The robot that --from or --example names; empty: neither. FM0001 for an example that does not exist.
std::string given_robot(const Options& options, const std::string& data_dir, Diagnostics& diagnostics) {
  if (options.example.empty()) return options.from;
  const std::string folder = data_dir + "/examples";
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (entry.is_regular_file() && file.size() > 5 && file.substr(file.size() - 5) == ".urdf")
      names.push_back(file.substr(0, file.size() - 5));
  }
  std::sort(names.begin(), names.end());
  if (std::find(names.begin(), names.end(), options.example) != names.end())
    return folder + "/" + options.example + ".urdf";
  suggest(diagnostics.error(code::usage, {}, fmt::format("there is no example '{}'", options.example)), options.example,
          names);
  return {};
}

/// Names of the files that generate would write, the manifest included.
std::vector<std::string> generated_names(const PlannedRobot& planned) {
  std::vector<std::string> names;
  for (const std::string& name : output_names(planned.robot, planned.forest)) names.push_back("generated/" + name);
  names.push_back(std::string("generated/") + kManifestName);
  return names;
}

bool is_sample(const OutputFile& file) {
  return file.name == kOwnRobot || file.name.rfind("src/devices/", 0) == 0 || file.name.rfind("src/tests/", 0) == 0;
}

/// The project around a robot of the user's. Beside device types of its own nothing is added, which would make its
/// timing file stale: there is no sample, and no test of it.
std::optional<NewProject> plan_around(const Input& input, Keys keys, Sources& sources, Diagnostics& diagnostics) {
  const auto planned = plan_robot(input, sources, diagnostics);
  if (!planned) return std::nullopt;
  NewProject project{input_name(input.path), files_of_robot(input, planned->robot, sources, diagnostics),
                     generated_names(*planned)};
  keys["robot_file"] = project.robot_file;
  const bool has_types = !user_include_dirs(planned->robot).empty();
  if (has_types) keys["no_tests"] = "ignore";
  std::vector<OutputFile> common = common_files(input.data_dir, keys, diagnostics);
  const auto is_left_out = [&](const OutputFile& file) { return has_types ? is_sample(file) : file.name == kOwnRobot; };
  common.erase(std::remove_if(common.begin(), common.end(), is_left_out), common.end());
  add_new(project.files, std::move(common));
  return project;
}

/// The project with a robot of its own.
std::optional<NewProject> plan_own(const std::string& board_name, Input input, Keys keys, Sources& sources,
                                   Diagnostics& diagnostics) {
  auto library = load_library({input.data_dir, "", {}, {}}, sources, diagnostics);
  if (!library) return std::nullopt;
  const Board* board = named_board(board_name, *library, sources, diagnostics);
  if (board == nullptr || !add_places(*board, keys, diagnostics)) return std::nullopt;
  keys["board"] = board_name;
  NewProject project{input_name(kOwnRobot), common_files(input.data_dir, keys, diagnostics), {}};
  const auto own = std::find_if(project.files.begin(), project.files.end(),
                                [](const OutputFile& file) { return file.name == kOwnRobot; });
  input.path = input.data_dir + "/templates/project/" + kOwnRobot;  // beside the template of its device type
  input.text = &own->text;
  const auto planned = plan_robot(input, sources, diagnostics);
  if (!planned) return std::nullopt;
  project.generated = generated_names(*planned);
  return project;
}

}  // namespace

std::optional<NewProject> plan_project(const Options& options, const std::string& data_dir, Sources& sources,
                                       Diagnostics& diagnostics) {
  const std::string name = project_name(options.input);
  const Keys keys{{"project", name},  {"robot", name},    {"version", minor_version()},          {"board", ""},
                  {"light_port", ""}, {"button_pin", ""}, {"robot_file", input_name(kOwnRobot)}, {"no_tests", "error"}};
  Options of_robot;
  of_robot.input = given_robot(options, data_dir, diagnostics);
  of_robot.data_dir = data_dir;
  const bool is_own = of_robot.input.empty();
  const auto input = input_of(is_own ? of_robot : settings_of(of_robot, sources, diagnostics).options, diagnostics);
  if (!input || diagnostics.has_errors()) return std::nullopt;
  auto project =
      is_own ? plan_own(options.board.empty() ? kDefaultBoard : options.board, *input, keys, sources, diagnostics)
             : plan_around(*input, keys, sources, diagnostics);
  if (!project || diagnostics.has_errors()) return std::nullopt;
  std::sort(project->files.begin(), project->files.end(),
            [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  return project;
}

}  // namespace finemote::gen
