#include "generator/run/project.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "generator/model/firmware_inputs.hpp"
#include "generator/output/write.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::string generated_folder(const Project& project) { return project.request.folder + "/generated"; }

WriteOptions options_for_work(const Project& project) {
  WriteOptions options;
  options.way_out = "give " + project.option + " an empty folder, or one that finemote made";
  options.other_robot = "give " + project.option + " another folder for each robot";
  return options;
}

/// Files beside a user's descriptors: the compiler reads them.
std::vector<std::string> files_of_the_compiler(const FirmwareRequest& request) {
  std::vector<std::string> files;
  std::error_code ignored;
  for (const std::string& dir : request.include_dirs) {
    for (const auto& entry : fs::directory_iterator(dir, ignored)) files.push_back(entry.path().generic_string());
  }
  return files;
}

/// The sources in folders, sorted in each: the order in which finemote_add_firmware links them.
std::vector<std::string> user_sources(const std::vector<std::string>& dirs) {
  std::vector<std::string> sources;
  for (const std::string& dir : dirs) {
    const auto first = static_cast<std::ptrdiff_t>(sources.size());
    for (const auto& entry : fs::directory_iterator(dir)) {
      if (entry.path().extension() == ".cpp") sources.push_back(entry.path().string());
    }
    std::sort(sources.begin() + first, sources.end());
  }
  return sources;
}

}  // namespace

FirmwareRequest firmware_of(const Robot& robot, std::string folder, std::string data_dir) {
  FirmwareRequest request;
  request.folder = std::move(folder);
  request.data_dir = std::move(data_dir);
  request.board = robot.board->name;
  request.for_host = robot.board->is_host();
  request.code_in_sram = runs_code_in_sram(robot);
  request.include_dirs = user_include_dirs(robot);
  request.sources = user_sources(request.include_dirs);
  return request;
}

Project make_project(const FirmwareRequest& request, Output generated, const Robot& robot, const EmulatedParts* parts) {
  std::vector<OutputFile> files{{"CMakeLists.txt", project_text(request)}};
  if (parts != nullptr) files.push_back({"parts.json", parts->scenario.dump(2) + "\n"});
  Output project = make_output(std::move(files), generated.manifest.inputs, robot.name.text);
  return {request, std::move(generated), std::move(project), "--keep"};
}

bool is_free_to_write(const Project& project, const std::vector<PlannedFile>& results, Sources& sources,
                      Diagnostics& diagnostics) {
  const FirmwareRequest& request = project.request;
  std::vector<PlannedFile> planned = planned_files(generated_folder(project), project.generated, project.option);
  for (PlannedFile& file : planned_files(request.folder, project.project, project.option))
    planned.push_back(std::move(file));
  planned.push_back({image_path(request), project.option});
  std::copy_if(results.begin(), results.end(), std::back_inserter(planned),
               [](const PlannedFile& result) { return !result.path.empty(); });
  if (!check_outputs(planned, sources, diagnostics, files_of_the_compiler(request))) return false;
  WriteOptions options = options_for_work(project);
  options.dry_run = true;
  Diagnostics said;  // warnings are repeated when the files are written
  write_output(request.folder, project.project, options, sources, said);
  if (!said.has_errors()) write_output(generated_folder(project), project.generated, options, sources, said);
  if (!said.has_errors()) return true;
  for (const Diagnostic& finding : said.in_file_order()) diagnostics.add(finding);
  return false;
}

bool write_project(const Project& project, Sources& sources, Diagnostics& diagnostics) {
  write_output(generated_folder(project), project.generated, options_for_work(project), sources, diagnostics);
  if (diagnostics.has_errors()) return false;
  write_output(project.request.folder, project.project, options_for_work(project), sources, diagnostics);
  return !diagnostics.has_errors();
}

std::optional<std::string> make_image(const Project& project, Sources& sources, Diagnostics& diagnostics) {
  if (!write_project(project, sources, diagnostics)) return std::nullopt;
  return build_firmware(project.request, diagnostics);
}

}  // namespace finemote::gen
