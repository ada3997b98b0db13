#include "generator/pipeline.hpp"

#include <algorithm>
#include <cerrno>

#include "generator/emit/link.hpp"
#include "generator/input/read_document.hpp"
#include "generator/model/asked_board.hpp"
#include "generator/model/build.hpp"
#include "generator/model/firmware_inputs.hpp"
#include "generator/tasks/remodel.hpp"

namespace finemote::gen {
namespace {

LibraryOptions library_of(const Input& input) {
  return {input.data_dir, input_folder(input.path), input.device_paths, {}};
}

ModelOptions model_of(const Input& input) {
  ModelOptions options;
  options.board = input.board;
  options.code = input.code;
  options.source = input_name(input.path);
  options.from_xacro = is_xacro(input.path);
  return options;
}

/// Whether there is such a file, though it may be one that cannot be read.
bool is_there(const std::string& path, const files::Access& access) {
  const auto denial = access.why_not(path);
  return !denial || (denial->error != ENOENT && denial->error != ENOTDIR);
}

void take_timing_file(const Input& input, PlannedRobot& planned, Sources& sources, Diagnostics& diagnostics) {
  const std::string path = timing_file_path(input.path);
  if (path.empty() || !is_there(path, sources.access())) return;
  const auto file = read_timing_file(path, sources, diagnostics);
  if (!file) return;
  const TimingQuestion question{input.path, argument_words(input), planned.board,
                                timing_state_of(planned, input.data_dir, sources.access()).hash};
  planned.timing_file = {use_timing_file(*file, question, planned.robot, diagnostics), file->at, path, file->compiler};
}

}  // namespace

std::optional<PlannedRobot> plan_robot(const Input& input, Sources& sources, Diagnostics& diagnostics) {
  const auto document = read_document(input, sources, diagnostics);  // parse, expand
  if (!document) return std::nullopt;
  auto library = load_library(library_of(input), sources, diagnostics);
  if (!library) return std::nullopt;
  auto robot = build_model(*document, *library, model_of(input), sources, diagnostics);
  if (!robot || diagnostics.has_errors()) return std::nullopt;

  Forest forest = build_forest(*robot);
  Schedule schedule = plan_schedule(*robot, forest, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  PlannedRobot planned{std::move(*library), std::move(*robot), std::move(forest), std::move(schedule)};
  planned.board = asked_board(*document, input.board);
  if (!input.without_timing_file) take_timing_file(input, planned, sources, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(planned));
}

CommandFrames command_frames(const PlannedRobot& planned, const std::string& data_dir) {
  CommandFrames frames;
  const auto& devices = planned.robot.devices;
  const auto is_link = [](const Device& device) { return !device.type->link_role.empty(); };
  if (std::none_of(devices.begin(), devices.end(), is_link)) return frames;
  Diagnostics said;  // by whoever writes the files
  for (const DeviceLink& link : plan_links(planned.plan(), shipped_interfaces(data_dir + "/schemas"), said)) {
    if (auto frame = command_frame(link)) frames.emplace(link.device, std::move(*frame));
  }
  return frames;
}

TimingState timing_state_of(const PlannedRobot& planned, const std::string& data_dir, const files::Access& access) {
  Diagnostics said;  // by whoever writes the files
  const auto unknown = timing::robot_bounds(std::nullopt, planned.forest, planned.schedule);
  const auto generated = emit_files(planned, {unknown, unknown}, data_dir, said);
  return timing_state({generated, planned.robot.board->name, runs_code_in_sram(planned.robot) ? "sram" : "flash",
                       data_dir, user_include_dirs(planned.robot)},
                      access);
}

Analysis analyse_robot(const PlannedRobot& planned, Hints hints) {
  const auto& [robot, forest, schedule] = planned.plan();
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(robot, forest);
  request.inputs = true;
  if (hints == Hints::wanted) request.remodel = timing::robot_remodel(robot, forest);
  Analysis analysis;
  const auto tasks = timing::make_timing_model(robot, forest, schedule, analysis.findings);
  if (tasks) analysis.timing = timing::analyse(*tasks, request, analysis.findings);
  return analysis;
}

ProvenBounds prove_bounds(const PlannedRobot& planned, const Analysis& analysis) {
  const auto& [robot, forest, schedule] = planned.plan();
  return {timing::robot_bounds(analysis.timing, forest, schedule),
          timing::instrumented_bounds(robot, forest, schedule)};
}

std::vector<OutputFile> emit_files(const PlannedRobot& planned, const ProvenBounds& bounds, const std::string& data_dir,
                                   Diagnostics& diagnostics) {
  return render_files(planned.plan(), bounds, data_dir, diagnostics);
}

}  // namespace finemote::gen
