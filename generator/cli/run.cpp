// finemote run: generates, compiles, runs and measures a robot's firmware.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <numeric>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/model/attributes.hpp"
#include "generator/output/write.hpp"
#include "generator/run/build_firmware.hpp"
#include "generator/run/check_wcet.hpp"
#include "generator/run/emulate.hpp"
#include "generator/run/execute.hpp"
#include "generator/run/parts.hpp"
#include "generator/run/report.hpp"
#include "generator/timing/from_robot.hpp"
#include "generator/timing/operands.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A work folder that is removed at the end unless the user keeps it. Reports FM5002 when it cannot be made.
class WorkFolder {
 public:
  explicit WorkFolder(Context& context) : path_(context.options.keep), keep_(!context.options.keep.empty()) {
    std::error_code failed;
    if (keep_) {
      fs::create_directories(path_, failed);
      if (failed) report_unwritten(context, path_.generic_string(), system_reason(failed.value()));
      return;
    }
    const fs::path folder = fs::temp_directory_path(failed);
    std::string pattern = (folder / "finemote-run-XXXXXX").string();
    if (!failed && mkdtemp(pattern.data()) == nullptr) failed.assign(errno, std::generic_category());
    if (!failed) {
      path_ = pattern;
      return;
    }
    context.diagnostics
        .error(code::output_not_writable, {},
               fmt::format("cannot make a temporary folder: {}", system_reason(failed.value())))
        .hint("set TMPDIR to a folder that can be written, or give one with --keep");
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    if (!keep_ && !path_.empty()) fs::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  fs::path path_;
  bool keep_;
};

/// Least common multiple of the periods; none beyond `limit`.
std::optional<std::int64_t> hyperperiod(const Schedule& schedule, std::int64_t limit) {
  std::int64_t result = 1;
  for (const Bucket& bucket : schedule.buckets) {
    const std::int64_t factor = bucket.period_ns / std::gcd(result, bucket.period_ns);
    if (factor > limit / result) return std::nullopt;
    result *= factor;
  }
  return result;
}

/// Two hyperperiods, at least 100 ms and at most 1 s.
std::int64_t default_duration(const Schedule& schedule) {
  constexpr std::int64_t kShortest = 100'000'000;
  constexpr std::int64_t kLongest = 1'000'000'000;
  const auto whole = hyperperiod(schedule, kLongest);
  return whole ? std::clamp(2 * *whole, kShortest, kLongest) : kLongest;
}

std::optional<std::int64_t> duration_of(Context& context, const Schedule& schedule) {
  if (context.options.duration.empty()) return default_duration(schedule);
  const auto parsed = units::parse_duration(context.options.duration);
  if (parsed && *parsed > 0) return *parsed;
  context.diagnostics
      .error(code::usage, {},
             fmt::format("--duration must be a time greater than zero, got '{}'", context.options.duration))
      .hint("write for example --duration 100ms");
  return std::nullopt;
}

std::vector<std::string> user_include_dirs(const Robot& robot) {
  std::vector<std::string> dirs;
  for (const Device& device : robot.devices) {
    const std::string& dir = device.type->include_dir;
    if (!dir.empty() && std::find(dirs.begin(), dirs.end(), dir) == dirs.end()) dirs.push_back(dir);
  }
  return dirs;
}

std::vector<std::string> user_sources(const std::vector<std::string>& dirs) {
  std::vector<std::string> sources;
  for (const std::string& dir : dirs) {
    for (const auto& entry : fs::directory_iterator(dir)) {
      if (entry.path().extension() == ".cpp") sources.push_back(entry.path().string());
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

/// What stands beside `generated` in the work folder; with --keep, what hangs on the board stays as well.
std::vector<OutputFile> project_files(const Context& context, const Robot& robot, const FirmwareRequest& request) {
  std::vector<OutputFile> files{{"CMakeLists.txt", project_text(request)}};
  if (!context.options.keep.empty()) files.push_back({"parts.json", emulated_parts(robot).scenario.dump(2) + "\n"});
  return files;
}

WriteOptions options_for_work() {
  WriteOptions options;
  options.way_out = "give --keep an empty folder, or one that finemote made";
  options.other_robot = "give --keep another folder for each robot";
  return options;
}

/// Everything a run writes into its work folder before the compiler starts.
struct Project {
  FirmwareRequest request;
  Output generated;  ///< below `generated`
  Output project;    ///< what includes it
};

std::string generated_folder(const Project& project) { return project.request.folder + "/generated"; }

std::optional<Project> make_project(Context& context, const Loaded& loaded, const Board& board, std::int64_t duration,
                                    const WorkFolder& work) {
  auto files = render_robot(context, loaded);
  if (context.diagnostics.has_errors()) return std::nullopt;
  const auto inputs = input_files(context, loaded);
  Options options = context.options;
  options.board.clear();  // chooses what is built of the files, not what is in them
  Project made;
  made.generated = make_output(std::move(files), inputs, loaded.robot.name.text, output_options(options));
  FirmwareRequest& request = made.request;
  request.folder = work.path();
  request.data_dir = loaded.data_dir;
  request.board = board.name;
  request.for_host = board.chip == "host";
  request.duration_ns = context.options.build_only || board.is_emulated ? 0 : duration;
  request.trace = !context.options.build_only;
  request.monitor = context.options.monitor;
  request.include_dirs = user_include_dirs(loaded.robot);
  request.sources = user_sources(request.include_dirs);
  made.project = make_output(project_files(context, loaded.robot, request), inputs, loaded.robot.name.text);
  return made;
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

/// Whether all of it can be written: looked at before the first file is.
bool is_free_to_write(Context& context, const Project& made) {
  std::vector<PlannedFile> planned = planned_files(generated_folder(made), made.generated, "--keep");
  for (PlannedFile& file : planned_files(made.request.folder, made.project, "--keep"))
    planned.push_back(std::move(file));
  planned.push_back({image_path(made.request), "--keep"});
  if (!context.options.out.empty()) planned.push_back({context.options.out, "-o"});
  const bool is_apart =
      check_outputs(planned, context.sources, context.diagnostics, files_of_the_compiler(made.request));
  if (!is_apart) return false;
  WriteOptions options = options_for_work();
  options.dry_run = true;
  Diagnostics said;  // warnings are repeated when the files are written
  write_output(made.request.folder, made.project, options, context.sources, said);
  if (!said.has_errors()) write_output(generated_folder(made), made.generated, options, context.sources, said);
  if (said.has_errors()) add_findings(said, context.diagnostics);
  return !said.has_errors();
}

std::optional<std::string> make_image(Context& context, const Project& made) {
  write_output(generated_folder(made), made.generated, options_for_work(), context.sources, context.diagnostics);
  if (context.diagnostics.has_errors()) return std::nullopt;
  write_output(made.request.folder, made.project, options_for_work(), context.sources, context.diagnostics);
  if (context.diagnostics.has_errors()) return std::nullopt;
  return build_firmware(made.request, context.diagnostics);
}

bool all_constant(const Robot& robot) {
  return std::all_of(robot.devices.begin(), robot.devices.end(), [](const Device& d) { return d.type->constant_init; });
}

/// The image as it runs: with the cost of its trace.
timing::Model model_of_image(const Context& context, const Loaded& loaded) {
  timing::RobotTimingOptions options;
  options.trace = true;
  options.monitor = context.options.monitor;
  return timing::make_timing_model(loaded.robot, loaded.forest, loaded.schedule, options);
}

std::optional<timing::Timing> bounds(const Context& context, const Loaded& loaded, const timing::Model& model,
                                     Diagnostics& diagnostics) {
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(loaded.robot, loaded.forest);
  request.chains = timing::parse_chains(model, context.options.chains, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return timing::analyse(model, request, diagnostics);
}

/// What analyze says of the robot, as warnings: none of it stops a run. None where it gives no answer.
std::optional<Verdict> repeat_verdict(Context& context, const Loaded& loaded) {
  Diagnostics said;
  Context apart{context.options, context.sources, said, context.out, context.err};
  auto verdict = timing_verdict(apart, loaded, CommandAges::left_out);
  if (verdict) {
    for (const Diagnostic& overload : verdict->overloads) said.add(overload);
    for (const Diagnostic& reason : verdict->reasons.in_file_order()) {
      if (reason.severity == Severity::error) said.add(reason);
    }
  }
  for (Diagnostic finding : said.in_file_order()) {
    finding.severity = Severity::warning;
    context.diagnostics.add(finding);
  }
  return verdict;
}

/// What the image was held to: the same numbers `generate` wrote into its sources.
timing::RobotBounds monitored_bounds(const Context& context, const Loaded& loaded) {
  if (!context.options.monitor) return {};
  return prove_bounds(loaded.robot, loaded.forest, loaded.schedule).monitored;
}

bool write_trace(Context& context, const RunResult& result) {
  if (context.options.out.empty()) return true;
  return write_result(context, context.options.out, run_trace(result).dump() + "\n");
}

/// The scenario that was asked for, judged before anything is generated; nothing: none, or a wrong one.
std::optional<Scenario> checked_scenario(Context& context, Loaded& loaded, const Board& board, std::int64_t duration) {
  if (context.options.scenario.empty()) return std::nullopt;
  if (!board.is_emulated) {
    const Board& own = *loaded.robot.board;
    context.diagnostics
        .error(code::scenario_unjudged, {}, fmt::format("nothing can play a scenario on the board '{}'", board.name))
        .note("it has no parts on its buses")
        .hint(fmt::format("--board {}", own.is_emulated ? own.name : suggested_board(loaded.library, context.sources)));
    return std::nullopt;
  }
  return read_scenario(context.options.scenario, loaded.robot, duration, context.sources, context.diagnostics);
}

std::optional<RunRecord> run_image(Context& context, const Loaded& loaded, const Board& board, const std::string& image,
                                   const FaultTable& faults, std::int64_t duration, const Scenario* scenario) {
  if (board.is_emulated) {
    return emulate(image, loaded.robot, loaded.forest, duration,
                   {board, faults, scenario, context.options.flash == "miss"}, context.diagnostics);
  }
  return execute(image, board.name, loaded.forest, duration, faults, context.diagnostics);
}

int finish_build(Context& context, const ImageFacts& image, const std::string& board) {
  if (context.options.format == Format::text && !context.diagnostics.has_errors()) print_image(image, context.out);
  return finish(context, kExitYes,
                Json{{"schema", "finemote.build/1"},
                     {"board", board},
                     {"image",
                      {{"sha256", image.sha256},
                       {"flash", image.flash},
                       {"ram", image.ram},
                       {"stack", image.stack ? Json(*image.stack) : Json(nullptr)}}}});
}

/// The board that plays the robot: its own, or that of --board. Null after what is wrong with it was reported: FM3007
/// where there is none of that name, FM3012 where it lacks a port of the robot.
const Board* playing_board(Context& context, Loaded& loaded) {
  const std::string& name = context.options.board;
  if (name.empty()) return loaded.robot.board;
  const std::vector<std::string> known = board_names(loaded.library);
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    suggest(context.diagnostics.error(code::unknown_board, {}, fmt::format("there is no board '{}'", name)), name,
            known);
    return nullptr;
  }
  const Board* board = find_board(loaded.library, name, context.sources, context.diagnostics);
  for (const Bus& bus : loaded.robot.buses) {
    if (board == nullptr || board->stands_in || bus.port.empty() || board->port(bus.port) != nullptr) continue;
    context.diagnostics
        .error(code::unknown_port, {}, fmt::format("board '{}' has no port '{}', which the robot uses", name, bus.port))
        .hint(fmt::format("leave out --board: the robot's own is '{}'", loaded.robot.board->name));
    return nullptr;
  }
  return board;
}

}  // namespace

int run_run(Context& context) {
  // The board chosen here runs the image; the robot keeps its own board, so the generated files are the same.
  Options load_options = context.options;
  load_options.board.clear();
  Context load_context{load_options, context.sources, context.diagnostics, context.out, context.err};
  auto loaded = load_robot(load_context);
  if (!loaded) return finish(context, kExitInvalid);
  const Board* playing = playing_board(context, *loaded);
  if (playing == nullptr) return finish(context, kExitInvalid);
  const Board& board = *playing;
  const auto duration = duration_of(context, loaded->schedule);
  if (!duration) return finish(context, kExitInvalid);

  const auto scenario = checked_scenario(context, *loaded, board, *duration);
  if (!scenario && !context.options.scenario.empty()) return finish(context, kExitInvalid);

  const bool has_parts = board.is_emulated && !context.options.build_only;
  if (has_parts && !has_models(loaded->robot, context.diagnostics)) return finish(context, kExitInvalid);
  if (board.is_emulated) warn_of_undriven(loaded->robot, context.diagnostics);

  Diagnostics analysis;  // of the image with its trace; what is wrong with the robot has been said
  const timing::Model model = model_of_image(context, *loaded);
  const auto timing = bounds(context, *loaded, model, analysis);
  for (const Diagnostic& finding : analysis.in_file_order()) {
    if (finding.code == code::timing_chain) context.diagnostics.add(finding);
  }
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);

  const WorkFolder work(context);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  const auto project = make_project(context, *loaded, board, *duration, work);
  if (!project || !is_free_to_write(context, *project)) return finish(context, kExitInvalid);
  if (has_parts &&
      !rehearse(board, scenario ? &*scenario : nullptr, loaded->robot, work.path() + "/scenario", context.diagnostics))
    return finish(context, kExitInvalid);
  const auto path = make_image(context, *project);
  if (!path) return finish(context, kExitInvalid);
  const auto image = image_facts(*path, board.chip != "host", !all_constant(loaded->robot), context.diagnostics);
  if (!image || context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  if (context.options.build_only) return finish_build(context, *image, board.name);
  const auto verdict = repeat_verdict(context, *loaded);
  const FaultTable faults = load_fault_table(loaded->data_dir);
  auto record = run_image(context, *loaded, board, *path, faults, *duration, scenario ? &*scenario : nullptr);
  if (!record) return finish(context, kExitInvalid);
  if (board.is_emulated) check_wcet(loaded->robot, *record, model.costs.stage_ns, context.diagnostics);
  RunResult result{loaded->robot,
                   loaded->forest,
                   loaded->schedule,
                   board.name,
                   *duration,
                   *duration,
                   *image,
                   std::move(*record),
                   {},
                   faults,
                   monitored_bounds(context, *loaded)};
  if (timing) result.chains = measure_chains(loaded->robot, loaded->forest, *timing, result.record);
  if (const auto whole = hyperperiod(loaded->schedule, *duration)) result.shown_ns = std::min(2 * *whole, *duration);
  if (verdict) result.schedulable = verdict->schedulable;
  if (board.is_emulated) result.wcets = measured_wcets(loaded->robot, result.record);
  if (!write_trace(context, result)) return finish(context, kExitInvalid);
  if (context.options.format == Format::text) print_run(result, context.out);
  const bool allowed = context.options.allow_unschedulable || result.schedulable.value_or(true);
  return finish(context, result.good() && allowed ? kExitYes : kExitNo, run_document(result));
}

}  // namespace finemote::gen
