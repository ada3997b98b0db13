#include "generator/pipeline.hpp"

#include "generator/input/read_document.hpp"
#include "generator/model/build.hpp"
#include "generator/timing/remodel.hpp"

namespace finemote::gen {
namespace {

LibraryOptions library_of(const Input& input) {
  return {input.data_dir, input_folder(input.path), input.device_paths, {}};
}

ModelOptions model_of(const Input& input) {
  ModelOptions options;
  options.board = input.board;
  options.source = input_name(input.path);
  options.from_xacro = is_xacro(input.path);
  return options;
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
  return PlannedRobot{std::move(*library), std::move(*robot), std::move(forest), std::move(schedule)};
}

Analysis analyse_robot(const PlannedRobot& planned, Hints hints) {
  const auto& [library, robot, forest, schedule] = planned;
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
  const auto& [library, robot, forest, schedule] = planned;
  return {timing::robot_bounds(analysis.timing, forest, schedule),
          timing::instrumented_bounds(robot, forest, schedule)};
}

std::vector<OutputFile> emit_files(const PlannedRobot& planned, const ProvenBounds& bounds, const std::string& data_dir,
                                   Diagnostics& diagnostics) {
  return render_files(planned.plan(), bounds, data_dir, diagnostics);
}

}  // namespace finemote::gen
