// finemote run: generates, compiles, runs and measures a robot's firmware.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "emulator/silicon/choice.hpp"
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/named_board.hpp"
#include "generator/cli/progress.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/subject.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/firmware_inputs.hpp"
#include "generator/run/audit.hpp"
#include "generator/run/check_wcet.hpp"
#include "generator/run/duration.hpp"
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

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Where a robot runs, how long and under what: settled before anything is generated.
struct Setup {
  const Board& board;
  Duration duration;
  std::optional<Scenario> scenario;
  std::vector<std::string> silicon;  ///< which freedom of its manual the emulated chip uses

  [[nodiscard]] bool is_emulated() const { return board.is_emulated; }
  [[nodiscard]] const Scenario* asked_scenario() const { return scenario ? &*scenario : nullptr; }
};

std::optional<Duration> duration_of(const std::string& asked, const Schedule& schedule, Diagnostics& diagnostics) {
  if (asked.empty()) return default_duration(schedule);
  return time_option("--duration", asked, "100ms", diagnostics);
}

/// The first bus whose port the board lacks; null: none, or the board takes every port.
const Bus* bus_without_port(const Robot& robot, const Board& board) {
  if (board.stands_in) return nullptr;
  const auto lacks = [&](const Bus& bus) { return !bus.port.empty() && board.port(bus.port) == nullptr; };
  const auto found = std::find_if(robot.buses.begin(), robot.buses.end(), lacks);
  return found == robot.buses.end() ? nullptr : &*found;
}

/// The board that plays the robot: its own, or that of --board. Null after what is wrong with it was reported: FM3007
/// where there is none of that name, FM3012 where it lacks a port of the robot.
const Board* playing_board(const std::string& name, PlannedRobot& planned, Sources& sources, Diagnostics& diagnostics) {
  if (name.empty()) return planned.robot.board;
  const Board* board = named_board(name, planned.library, sources, diagnostics);
  const Bus* bus = board != nullptr ? bus_without_port(planned.robot, *board) : nullptr;
  if (bus == nullptr) return board;
  diagnostics
      .error(code::unknown_port, {}, fmt::format("board '{}' has no port '{}', which the robot uses", name, bus->port))
      .hint(fmt::format("leave out --board: the robot's own is '{}'", planned.robot.board->name));
  return nullptr;
}

/// The scenario that was asked for; none where it is wrong.
std::optional<Scenario> read_asked_scenario(const std::string& path, PlannedRobot& planned, const Setup& setup,
                                            Sources& sources, Diagnostics& diagnostics) {
  if (setup.is_emulated()) return read_scenario(path, planned.robot, setup.duration, sources, diagnostics);
  const Board& own = *planned.robot.board;
  diagnostics
      .error(code::scenario_unjudged, {},
             fmt::format("nothing can play a scenario on the board '{}'", setup.board.name))
      .note("it has no parts on its buses")
      .hint(fmt::format("--board {}", own.is_emulated ? own.name : suggested_board(planned.library, sources)));
  return std::nullopt;
}

/// Reports what only the emulated board can do.
bool can_watch(const Options& options, const Setup& setup, Diagnostics& diagnostics) {
  const char* asked = !options.audit.empty()     ? "--audit"
                      : options.phases != 0      ? "--phases"
                      : !options.silicon.empty() ? "--silicon"
                      : options.slowest          ? "--slowest"
                                                 : nullptr;
  if (setup.is_emulated() || asked == nullptr) return true;
  diagnostics
      .error(
          code::scenario_unjudged, {},
          fmt::format("'{}' needs the emulated board: '{}' has no parts and keeps no record", asked, setup.board.name))
      .hint("leave out --board");
  return false;
}

std::optional<Setup> setup_of(const Options& options, PlannedRobot& planned, Sources& sources,
                              Diagnostics& diagnostics) {
  const Board* board = playing_board(options.board, planned, sources, diagnostics);
  if (board == nullptr) return std::nullopt;
  const auto duration = duration_of(options.duration, planned.schedule, diagnostics);
  if (!duration) return std::nullopt;
  const std::string strictness = options.slowest && options.silicon.empty() ? "strict" : options.silicon;
  auto silicon = emulator::parse_silicon(strictness, diagnostics);
  if (!silicon) return std::nullopt;
  Setup setup{*board, *duration, {}, std::move(*silicon)};
  if (!can_watch(options, setup, diagnostics)) return std::nullopt;
  if (options.scenario.empty()) return setup;
  setup.scenario = read_asked_scenario(options.scenario, planned, setup, sources, diagnostics);
  if (!setup.scenario) return std::nullopt;
  return setup;
}

/// Whether the emulated board has what hangs on the robot's buses.
bool has_parts(const Robot& robot, const Setup& setup, bool build_only, Diagnostics& diagnostics) {
  if (!setup.is_emulated()) return true;
  if (!build_only && !has_models(robot, diagnostics)) return false;
  warn_of_undriven(robot, diagnostics);
  return true;
}

/// The analysis of the image as it runs, with its trace and monitor; none: no answer. Reports FM4018 for chains that do
/// not exist; what else is wrong with the image is wrong with the robot.
std::optional<timing::Timing> analyse_image(const Options& options, const PlannedRobot& planned,
                                            Diagnostics& diagnostics) {
  const auto& [library, robot, forest, schedule, timing_file] = planned;
  timing::RobotTimingOptions instrumented;
  instrumented.trace = options.trace;
  instrumented.monitor = options.monitor;
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(robot, forest);
  Diagnostics findings;
  const auto model = timing::make_timing_model(robot, forest, schedule, findings, instrumented);
  if (!model) return std::nullopt;
  request.chains = timing::parse_chains(*model, options.chains, findings);
  std::optional<timing::Timing> timing;
  if (!findings.has_errors()) timing = timing::analyse(*model, request, findings);
  for (const Diagnostic& finding : findings.in_file_order()) {
    if (finding.code == code::timing_chain) diagnostics.add(finding);
  }
  return timing;
}

FirmwareRequest firmware_request(const Options& options, const Setup& setup, const Robot& robot,
                                 const std::string& folder, const std::string& data_dir) {
  FirmwareRequest request;
  request.folder = folder;
  request.data_dir = data_dir;
  request.board = setup.board.name;
  request.for_host = setup.board.is_host();
  request.duration = options.build_only || setup.is_emulated() ? Duration::zero() : setup.duration;
  request.trace = options.trace || (!setup.is_emulated() && !options.build_only);
  request.monitor = options.monitor;
  request.code_in_sram = setup.is_emulated() && runs_code_in_sram(robot);
  request.include_dirs = user_include_dirs(robot);
  request.sources = user_sources(request.include_dirs);
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

std::optional<RunRecord> run_image(const WatchedImage& watched, const PlannedRobot& planned, const Setup& setup,
                                   const FaultTable& faults, const Options& options, std::optional<Phase> phase,
                                   Diagnostics& diagnostics) {
  const auto& [library, robot, forest, schedule, timing_file] = planned;
  const std::string& image = watched.image.path;
  if (!setup.is_emulated()) return execute(image, setup.board, forest, setup.duration, faults, diagnostics);
  return emulate(image, robot, forest, setup.duration,
                 {setup.board, faults, watched.loops, setup.asked_scenario(),
                  options.audit.empty() ? nullptr : &schedule, phase, options.flash_misses || options.slowest,
                  SiliconChoice{setup.silicon, options.seed + (phase ? phase->number : 0)}},
                 diagnostics);
}

/// Everything that the runs have left behind and shown.
struct Runs {
  RunRecord record;
  RunFigures figures;
  std::string audit;  ///< empty where it was not asked for
};

/// One run without phases, or as many as were asked for.
std::optional<Runs> run_phases(const WatchedImage& watched, const PlannedRobot& planned, const Setup& setup,
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
    RunFigures figures =
        figures_of(planned.robot, planned.forest, timing ? &*timing : nullptr, *record, setup.is_emulated());
    if (!all) {
      all = Runs{std::move(*record), std::move(figures), {}};
    } else {
      merge(all->record, *record);
      merge(all->figures, figures);
    }
  }
  all->audit = std::move(audit);
  return all;
}

/// What was run, and what it left behind.
RunResult result_of(const PlannedRobot& planned, const Setup& setup, const ImageFacts& image, Runs runs,
                    const FaultTable& faults) {
  const auto& [library, robot, forest, schedule, timing_file] = planned;
  const auto whole = hyperperiod(schedule, setup.duration);
  const bool fits_twice = whole && *whole <= floor_div(setup.duration, 2);
  const Duration shown = fits_twice ? 2 * *whole : setup.duration;
  return {robot,
          forest,
          schedule,
          setup.board.name,
          setup.duration,
          shown,
          image,
          std::move(runs.record),
          std::move(runs.figures),
          faults,
          {}};
}

Answer answer_of_build(const ImageFacts& image, const std::string& board) {
  std::ostringstream text;
  print_image(image, text);
  return {kExitYes, text.str(),
          Json{{"schema", "finemote.build/1"},
               {"board", board},
               {"image",
                {{"sha256", image.sha256},
                 {"flash", image.flash},
                 {"ram", image.ram},
                 {"code_ram", image.code_ram},
                 {"stack", image.stack ? Json(*image.stack) : Json(nullptr)}}}}};
}

Answer answer_of_run(const Options& options, const RunResult& result, Diagnostics& diagnostics) {
  if (!options.out.empty() && !write_result(options.out, run_trace(result).dump() + "\n", diagnostics))
    return no_answer();
  std::ostringstream text;
  if (options.format == Format::text) print_run(result, options.verbose, text);
  const bool allowed = options.allow_unschedulable || result.schedulable.value_or(true);
  const bool is_enough = !options.require_judged || result.is_all_judged();
  return {result.good() && allowed && is_enough ? kExitYes : kExitNo, text.str(), run_document(result)};
}

}  // namespace

Answer run_run(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  input->board.clear();  // --board runs the image; the robot keeps its own board, so the generated files are the same
  if (options.dump) return dump_robot(options, *input, {}, sources, diagnostics);
  auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  note_command_frames(*planned, input->data_dir);
  const auto& [library, robot, forest, schedule, timing_file] = *planned;
  const auto setup = setup_of(options, *planned, sources, diagnostics);
  if (!setup || !has_parts(robot, *setup, options.build_only, diagnostics)) return no_answer();
  const auto image_timing = analyse_image(options, *planned, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  const FaultTable faults = load_fault_table(input->data_dir);
  const std::vector<PlannedFile> results{{options.out, "-o"}, {options.audit, "--audit"}, {options.json, "--json"}};
  const auto read = user_files(robot, sources.access());
  if (!check_results(results, sources, diagnostics, read, options.keep)) return no_answer();
  const WorkFolder work(options.keep, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  const Analysis analysis = analyse_robot(*planned, options.build_only ? Hints::left_out : Hints::wanted);
  ProvenBounds proven = prove_bounds(*planned, analysis);
  auto files = emit_files(*planned, proven, input->data_dir, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  const FirmwareRequest request = firmware_request(options, *setup, robot, work.path(), input->data_dir);
  const Project project =
      make_project(request, output_of(std::move(files), *planned, *input, sources), robot, !options.keep.empty());
  if (!is_free_to_write(project, results, sources, diagnostics)) return no_answer();
  const bool is_played = setup->is_emulated() && !options.build_only;
  if (is_played && !rehearse(setup->board, setup->asked_scenario(), robot, work.path() + "/scenario", diagnostics))
    return no_answer();
  Progress progress(options);
  progress.say("compiling the firmware");
  const auto image = make_proven_image(project, robot, !options.keep.empty(), sources, diagnostics);
  if (!image) return no_answer();
  if (options.build_only) return answer_of_build(image->facts, setup->board.name);

  const auto schedulable = repeat_verdict(analysis, diagnostics);
  WatchedImage watched = watch_loops(*image, *input, is_played, diagnostics);
  auto runs = run_phases(watched, *planned, *setup, faults, options, image_timing, progress, diagnostics);
  if (!runs) return no_answer();
  if (!options.audit.empty() && !write_result(options.audit, runs->audit, diagnostics)) return no_answer();
  RunResult result = result_of(*planned, *setup, image->facts, std::move(*runs), faults);
  result.phases = std::max<std::uint64_t>(options.phases, 1);
  result.seed = options.phases == 0 ? 0 : options.seed;
  if (options.monitor) result.bounds = std::move(proven.monitored);
  result.schedulable = schedulable;
  Diagnostics judged;
  for (const Device& device : robot.devices) result.wcets_given.push_back(device.wcet);
  if (image_timing) result.wcets_given = analysed_wcets(robot, forest, image_timing->model);
  const bool declared_hold = !image_timing || image_timing->above_declared.empty();
  result.wcets_hold = check_wcet(robot, result.wcets_given, result.record, judged) && declared_hold;
  result.loops = std::move(watched.loops);
  result.loops_hold = check_loops(result.loops, result.record.loop_passes, judged);
  result.traffic_holds = !result.record.violated.empty() || check_traffic(robot, result.figures.traffic, judged);
  result.must_judge = setup->is_emulated();
  result.wcets = measured_wcets(robot, result.record);
  result.order = judge_order(robot, planned->schedule, result.record);
  Answer answer = answer_of_run(options, result, diagnostics);
  answer.judged = std::move(judged);
  return answer;
}

}  // namespace finemote::gen
