#include "generator/cli/dump.hpp"

#include <fmt/format.h>

#include "generator/cli/robot_input.hpp"
#include "generator/cli/subject.hpp"
#include "generator/dump/dump.hpp"
#include "generator/emit/plan_files.hpp"
#include "generator/input/input.hpp"
#include "generator/input/read_document.hpp"

namespace finemote::gen {
namespace {

/// None after an error.
std::optional<Json> stage_json(DumpStage stage, const Input& input, const timing::RobotTimingOptions& tasks,
                               Sources& sources, Diagnostics& diagnostics) {
  if (stage == DumpStage::document) {
    const auto document = read_document(input, sources, diagnostics);
    return document ? std::optional(dump_document(*document)) : std::nullopt;
  }
  const auto planned = plan_robot(input, sources, diagnostics);
  if (!planned) return std::nullopt;
  const auto& [robot, forest, schedule] = planned->plan();
  if (stage == DumpStage::model) return dump_model(robot);
  if (stage == DumpStage::forest) return dump_forest(robot, forest);
  if (stage == DumpStage::schedule) return dump_schedule(robot, schedule);
  if (stage == DumpStage::tasks) {
    const auto model = timing::make_timing_model(robot, forest, schedule, diagnostics, tasks);
    return model ? std::optional(dump_tasks(*model)) : std::nullopt;
  }
  const ProvenBounds bounds = prove_bounds(*planned, analyse_robot(*planned, Hints::left_out));
  const auto files = plan_files(planned->plan(), bounds, input.data_dir, diagnostics);
  return dump_plan(files, input.data_dir + "/templates");
}

Answer answer_of(const Options& options, const Json& stage, const Diagnostics& diagnostics) {
  if (is_refused(options, diagnostics)) return no_answer();
  return {kExitYes, document_text(stage)};
}

}  // namespace

Answer dump_robot(const Options& options, const Input& input, const timing::RobotTimingOptions& tasks, Sources& sources,
                  Diagnostics& diagnostics) {
  const auto stage = stage_json(*options.dump, input, tasks, sources, diagnostics);
  return stage ? answer_of(options, *stage, diagnostics) : no_answer();
}

Answer dump_subject(const Options& options, const timing::RobotTimingOptions& tasks, Sources& sources,
                    Diagnostics& diagnostics) {
  if (!is_timing_model(options.input)) {
    const auto input = input_of(options, diagnostics);
    return input ? dump_robot(options, *input, tasks, sources, diagnostics) : no_answer();
  }
  if (*options.dump != DumpStage::tasks) {
    const char* name = kStageNames[static_cast<std::size_t>(*options.dump)];
    diagnostics
        .error(code::usage, {}, fmt::format("'{}' is a timing model, which has no stage '{}'", options.input, name))
        .hint("--dump tasks");
    return no_answer();
  }
  const auto subject = read_subject(options, tasks, sources, diagnostics);
  return subject ? answer_of(options, dump_tasks(subject->model), diagnostics) : no_answer();
}

}  // namespace finemote::gen
