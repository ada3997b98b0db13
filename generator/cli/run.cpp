// finemote run: generates, compiles, runs and measures a robot's firmware.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/progress.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/run_setup.hpp"
#include "generator/cli/subject.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/run/audit.hpp"
#include "generator/run/check_routines.hpp"
#include "generator/run/check_wcet.hpp"
#include "generator/run/emulate.hpp"
#include "generator/run/execute.hpp"
#include "generator/run/project.hpp"
#include "generator/run/proven_image.hpp"
#include "generator/run/run_document.hpp"
#include "generator/run/run_text.hpp"
#include "generator/run/run_trace.hpp"
#include "generator/run/told_loops.hpp"
#include "generator/run/work_folder.hpp"
#include "generator/tasks/from_robot.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing_file/user_code.hpp"
#include "generator/units/hyperperiod.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Whether the emulated board has what hangs on the robot's buses.
bool has_parts(const Robot& robot, const RunSetup& setup, bool build_only, Diagnostics& diagnostics) {
  if (!setup.is_emulated()) return true;
  if (!build_only && !has_models(robot, diagnostics)) return false;
  warn_of_undriven(setup.parts, diagnostics);
  return true;
}

/// The analysis of the image as it runs, with its trace and monitor; none: no answer. Reports FM4018 for chains that do
/// not exist; what else is wrong with the image is wrong with the robot.
std::optional<timing::Timing> analyse_image(const Options& options, const PlannedRobot& planned,
                                            Diagnostics& diagnostics) {
  const auto& [robot, forest, schedule] = planned.plan();
  timing::RobotTimingOptions instrumented;
  instrumented.trace = options.trace;
  instrumented.monitor = options.monitor;
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(robot, forest);
  Diagnostics findings;
  const auto model = timing::make_timing_model(robot, forest, schedule, findings, instrumented);
  if (!model) return std::nullopt;
  request.every = true;
  request.chains = timing::parse_chains(*model, options.chains, findings);
  std::optional<timing::Timing> timing;
  if (!findings.has_errors()) timing = timing::analyse(*model, request, findings);
  for (const Diagnostic& finding : findings.in_file_order()) {
    if (finding.code == code::timing_chain) diagnostics.add(finding);
  }
  return timing;
}

/// What is written down beside the image that the user keeps.
const EmulatedParts* kept_parts(const Options& options, const RunSetup& setup) {
  return options.keep.empty() ? nullptr : &setup.parts;
}

FirmwareRequest firmware_request(const Options& options, const RunSetup& setup, const Robot& robot,
                                 const std::string& folder, const std::string& data_dir) {
  FirmwareRequest request = firmware_of(robot, folder, data_dir);
  request.board = setup.board.name;
  request.for_host = setup.board.is_host();
  request.code_in_sram = request.code_in_sram && setup.is_emulated();
  request.duration = options.build_only || setup.is_emulated() ? Duration::zero() : setup.duration;
  request.trace = options.trace || (!setup.is_emulated() && !options.build_only);
  request.monitor = options.monitor;
  return request;
}

/// What analyze says of the robot, as warnings: none of it stops a run.
/// @return  whether it is schedulable; none where there is no answer
std::optional<bool> repeat_verdict(const Analysis& analysis, Diagnostics& diagnostics) {
  Diagnostics said;
  const auto verdict = verdict_of(analysis, said);
  if (verdict) {
    for (const Diagnostic& overload : verdict->overloads) said.add(overload);
    for (const Diagnostic& reason : verdict->reasons.in_file_order()) {
      if (reason.severity == Severity::error) said.add(reason);
    }
  }
  for (Diagnostic finding : said.in_file_order()) {
    finding.severity = Severity::warning;
    diagnostics.add(finding);
  }
  return verdict ? std::optional(verdict->schedulable) : std::nullopt;
}

/// The same of the image with its trace and monitor, which no generated file rests on.
std::optional<bool> with_instruments(std::optional<bool> schedulable, const std::optional<timing::Timing>& image,
                                     Diagnostics& diagnostics) {
  if (!schedulable.value_or(false) || !image || image->schedulable) return schedulable;
  diagnostics.warning(
      code::timing_unschedulable, timing::at_first_device(image->model),
      "with its trace or monitor the robot may miss deadlines: see finemote analyze with the same option");
  return false;
}

/// What is run, and the loops whose passes are counted.
struct WatchedImage {
  const ProvenImage& image;
  std::vector<ToldLoop> loops;
};

/// @param is_counted  something counts the passes
WatchedImage watch_loops(const ProvenImage& image, const Input& input, bool is_counted, Diagnostics& diagnostics) {
  if (!is_counted) return {image, {}};
  return {image, told_loops(image.path, SourceNames(input.data_dir, input_folder(input.path)), diagnostics)};
}

std::optional<RunRecord> run_image(const WatchedImage& watched, const PlannedRobot& planned, const RunSetup& setup,
                                   const FaultTable& faults, const Options& options, std::optional<Phase> phase,
                                   Diagnostics& diagnostics) {
  const auto& [robot, forest, schedule] = planned.plan();
  const std::string& image = watched.image.path;
  if (!setup.is_emulated()) return execute(image, setup.board, robot, forest, setup.duration, faults, diagnostics);
  return emulate(image, robot, forest, setup.duration,
                 {setup.board, setup.parts, faults, watched.loops, setup.asked_scenario(),
                  options.audit.empty() ? nullptr : &schedule, phase, options.flash_misses || options.slowest,
                  SiliconChoice{setup.silicon, options.seed + (phase ? phase->number : 0)}},
                 diagnostics);
}

/// Everything that the runs have left behind and shown.
struct Runs {
  RunRecord record;
  RunFigures figures;
  OrderVerdict order;
  std::string audit;  ///< empty where it was not asked for
};

void merge(OrderVerdict& all, const OrderVerdict& more) {
  all.is_judged |= more.is_judged;
  if (!all.mistake) all.mistake = more.mistake;
}

/// One run without phases, or as many as were asked for.
std::optional<Runs> run_phases(const WatchedImage& watched, const PlannedRobot& planned, const RunSetup& setup,
                               const FaultTable& faults, const Options& options,
                               const std::optional<timing::Timing>& timing, Progress& progress,
                               Diagnostics& diagnostics) {
  std::optional<Runs> all;
  std::string audit;
  const std::uint64_t count = std::max<std::uint64_t>(options.phases, 1);
  for (std::uint64_t i = 0; i < count; ++i) {
    progress.say(fmt::format("running on {}: {} of {}", setup.board.name, i + 1, count));
    const auto phase = options.phases == 0 ? std::nullopt : std::optional(Phase{options.seed, i});
    auto record = run_image(watched, planned, setup, faults, options, phase, diagnostics);
    if (!record) return std::nullopt;
    if (!options.audit.empty()) {
      const AuditedRun run{watched.image.facts.sha256, options.phases == 0 ? 0 : options.seed, i};
      audit += audit_lines(planned.robot, planned.forest, planned.schedule, run, *record);
      record->log.clear();
    }
    RunFigures figures = figures_of(planned.robot, planned.forest, planned.schedule, timing ? &*timing : nullptr,
                                    *record, setup.is_emulated());
    OrderVerdict order = judge_order(planned.robot, planned.schedule, *record);
    if (!all) {
      all = Runs{std::move(*record), std::move(figures), std::move(order), {}};
    } else {
      merge(all->record, *record);
      merge(all->figures, figures);
      merge(all->order, order);
    }
  }
  leave_out_others(planned.robot, all->figures.chains);
  all->audit = std::move(audit);
  return all;
}

/// Holds what the runs have shown against what the robot and the sources say; reports what is wrong.
void judge(const PlannedRobot& planned, const std::optional<timing::Timing>& timing, RunResult& result,
           Diagnostics& judged) {
  const Robot& robot = planned.robot;
  for (const Device& device : robot.devices) result.wcets_given.push_back(device.wcet);
  if (timing) result.wcets_given = analysed_wcets(robot, planned.forest, timing->model);
  for (const Diagnostic& reason : result.record.stopped) judged.add(reason);
  result.declared_hold = !timing || timing->above_declared.empty();
  result.wcets_hold = check_wcet(robot, result.wcets_given, result.record, judged);
  if (timing && !check_routines(robot, timing->model, result.record, judged)) result.wcets_hold = false;
  result.loops_hold = check_loops(result.loops, result.record.loop_passes, judged);
  if (result.record.is_traffic_judged) {
    const bool bus_traffic_holds = check_traffic(robot, result.figures.traffic, judged);
    result.traffic_holds = check_pin_edges(result.figures.pins, judged) && bus_traffic_holds;
  }
  result.wcets = measured_wcets(robot, result.record);
}

/// What was run, and what it left behind.
RunResult result_of(const PlannedRobot& planned, const RunSetup& setup, const ImageFacts& image, Runs runs,
                    const FaultTable& faults) {
  const auto& [robot, forest, schedule] = planned.plan();
  const Duration lasted = std::max(setup.duration, runs.record.ready + runs.record.judged_for);
  return {robot,
          forest,
          schedule,
          setup.board.name,
          setup.duration,
          two_hyperperiods(schedule.buckets, lasted),
          image,
          std::move(runs.record),
          std::move(runs.figures),
          faults,
          {}};
}

Answer answer_of_build(const ImageFacts& image, const std::string& board) {
  std::ostringstream text;
  print_image(image, text);
  Json facts{{"sha256", image.sha256}};
  facts.update(sizes_json(image));
  return {kExitYes, text.str(), Json{{"schema", "finemote.build/1"}, {"board", board}, {"image", std::move(facts)}}};
}

Answer answer_of_run(const Options& options, const RunResult& result, Diagnostics& diagnostics) {
  if (!options.out.empty() && !write_result(options.out, run_trace(result).dump() + "\n", diagnostics))
    return no_answer();
  std::vector<std::string> failures = result.failures();
  if (!options.allow_unschedulable && !result.schedulable.value_or(true)) failures.emplace_back("not schedulable");
  if (options.require_judged && !result.is_all_judged()) failures.emplace_back("not everything was judged");
  std::ostringstream text;
  if (options.format == Format::text) print_run(result, failures, options.verbose, text);
  return {failures.empty() ? kExitYes : kExitNo, text.str(), run_document(result)};
}

/// Files beside the work folder.
std::vector<PlannedFile> results_of(const Options& options) {
  return {{options.out, "-o"}, {options.audit, "--audit"}, {options.json, "--json"}};
}

/// What is compiled, and what is proven of it.
struct Prepared {
  Analysis analysis;
  ProvenBounds proven;
  Project project;
};

/// Everything but the compiler's work. None after what is in the way was reported: nothing is written yet.
std::optional<Prepared> prepare(const Options& options, const Input& input, const PlannedRobot& planned,
                                const RunSetup& setup, const std::string& folder, Sources& sources,
                                Diagnostics& diagnostics) {
  Analysis analysis = analyse_robot(planned, options.build_only ? Hints::left_out : Hints::wanted);
  ProvenBounds proven = prove_bounds(planned, analysis);
  auto files = emit_files(planned, proven, input.data_dir, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const FirmwareRequest request = firmware_request(options, setup, planned.robot, folder, input.data_dir);
  Project project = make_project(request, output_of(std::move(files), planned, input, sources), planned.robot,
                                 kept_parts(options, setup));
  if (!is_free_to_write(project, results_of(options), sources, diagnostics)) return std::nullopt;
  const bool is_played = setup.is_emulated() && !options.build_only;
  if (is_played && !rehearse(setup.board, setup.parts, setup.asked_scenario(), folder + "/scenario", diagnostics))
    return std::nullopt;
  return Prepared{std::move(analysis), std::move(proven), std::move(project)};
}

}  // namespace

Answer run_run(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  input->board.clear();  // --board runs the image; the robot keeps its own board, so the generated files are the same
  if (options.dump) return dump_robot(options, *input, {}, sources, diagnostics);
  auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  const auto setup = run_setup(options, input->data_dir, *planned, sources, diagnostics);
  if (!setup || !has_parts(planned->robot, *setup, options.build_only, diagnostics)) return no_answer();
  const auto image_timing = analyse_image(options, *planned, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  const auto read = user_files(planned->robot, sources.access());
  if (!check_results(results_of(options), sources, diagnostics, read, options.keep)) return no_answer();
  const WorkFolder work(options.keep, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  auto prepared = prepare(options, *input, *planned, *setup, work.path(), sources, diagnostics);
  if (!prepared) return no_answer();
  Progress progress(options);
  progress.say("compiling the firmware");
  const auto image =
      make_proven_image(prepared->project, planned->robot, kept_parts(options, *setup), sources, diagnostics);
  if (!image) return no_answer();
  if (options.build_only) return answer_of_build(image->facts, setup->board.name);

  const auto schedulable = with_instruments(repeat_verdict(prepared->analysis, diagnostics), image_timing, diagnostics);
  const FaultTable faults = load_fault_table(input->data_dir);
  WatchedImage watched = watch_loops(*image, *input, setup->is_emulated(), diagnostics);
  auto runs = run_phases(watched, *planned, *setup, faults, options, image_timing, progress, diagnostics);
  if (!runs) return no_answer();
  if (!options.audit.empty() && !write_result(options.audit, runs->audit, diagnostics)) return no_answer();
  RunResult result = result_of(*planned, *setup, image->facts, std::move(*runs), faults);
  result.order = std::move(runs->order);
  result.phases = std::max<std::uint64_t>(options.phases, 1);
  result.seed = options.phases == 0 ? 0 : options.seed;
  if (options.monitor) result.bounds = std::move(prepared->proven.monitored);
  result.schedulable = schedulable;
  result.must_judge = setup->is_emulated();
  result.loops = std::move(watched.loops);
  Diagnostics judged;
  judge(*planned, image_timing, result, judged);
  Answer answer = answer_of_run(options, result, diagnostics);
  answer.judged = std::move(judged);
  return answer;
}

}  // namespace finemote::gen
