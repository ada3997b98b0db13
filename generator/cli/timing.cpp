// finemote analyze and finemote simulate: from a robot or a model to bounds, and to a run beside them.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"
#include "generator/diagnostic/clash.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/simulate/command.hpp"
#include "generator/timing/command.hpp"
#include "generator/timing/from_robot.hpp"
#include "generator/timing/read_model.hpp"
#include "generator/timing/remodel.hpp"
#include "generator/units/units.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

/// What there is to analyse, from either kind of input.
struct Question {
  timing::Model model;
  std::vector<timing::Requirement> requirements;
  std::shared_ptr<const Loaded> loaded;  ///< what the model was made from; none for a model
  timing::RobotTimingOptions options;
};

std::optional<std::int64_t> time_option(Context& context, const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto parsed = units::parse_duration(text);
  if (parsed && *parsed > 0) return *parsed;
  context.diagnostics.error(code::usage, {}, fmt::format("{} must be a time greater than zero, got '{}'", option, text))
      .hint(fmt::format("write for example {} 50us", option));
  return std::nullopt;
}

std::optional<timing::Profile> profile_option(Context& context) {
  const std::string& name = context.options.profile;
  if (name.empty()) return std::nullopt;
  const auto profile = timing::profile_of(name);
  if (!profile) {
    context.diagnostics.error(code::usage, {}, fmt::format("there is no profile '{}'", name))
        .hint("valid here: 'paper', 'tight', 'target'");
  }
  return profile;
}

std::optional<Question> read_question(Context& context, std::optional<std::int64_t> assumed) {
  if (std::filesystem::path(context.options.input).extension() == ".json") {
    const SourceFile* file = xml::read_source(context.options.input, context.sources, context.diagnostics);
    if (file == nullptr) return std::nullopt;
    auto model = timing::read_model(*file, context.diagnostics);
    if (!model || context.diagnostics.has_errors()) return std::nullopt;
    return Question{std::move(*model), {}, nullptr, {}};
  }
  auto robot = load_robot(context);
  if (!robot) return std::nullopt;
  const auto loaded = std::make_shared<const Loaded>(std::move(*robot));
  timing::RobotTimingOptions options;
  options.assumed_wcet_ns = assumed;
  return Question{timing::make_timing_model(loaded->robot, loaded->forest, loaded->schedule, options),
                  timing::timing_requirements(loaded->robot, loaded->forest), loaded, options};
}

/// Ends an analysis, whose findings have settled `status`, with the `result` it has written: table or document. Formats
/// for editors and CI have findings alone on stdout.
int finish_analysis(Context& context, int status, const std::string& result) {
  const Format format = context.options.format;
  const bool warnings_fail = context.options.warnings_are_errors && context.diagnostics.size() > 0;
  if (warnings_fail) status = kExitInvalid;
  const bool answered = status == kExitYes || status == kExitNo;
  if (format == Format::text || (format == Format::json && answered)) context.out << result;
  Diagnostics none;
  Context rest{context.options, context.sources, none, context.out, context.err};
  return finish_with(rest, status, context.diagnostics, nullptr);
}

}  // namespace

int run_analyze_command(Context& context) {
  timing::AnalyzeOptions request;
  request.profile = profile_option(context);
  request.chains = context.options.chains;
  request.slack = context.options.slack;
  request.suggest_order = context.options.suggest_order;
  request.json = context.options.format == Format::json;
  request.assume_wcet_ns = time_option(context, "--assume-wcet", context.options.assume_wcet);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  auto question = read_question(context, request.assume_wcet_ns);
  if (!question) return finish(context, kExitInvalid);
  if (question->loaded)
    request.remodel = timing::robot_remodel(question->loaded->robot, question->loaded->forest, question->options);
  std::ostringstream result;
  const int status =
      timing::run_analyze(std::move(question->model), question->requirements, request, context.diagnostics, result);
  return finish_analysis(context, status, result.str());
}

/// What takes hours at the usual periods; longer ones would seem to hang.
constexpr std::int64_t kLongestSimulation = 86'400'000'000'000;

int run_simulate_command(Context& context) {
  SimulateOptions request;
  request.seed = context.options.seed;
  request.chains = context.options.chains;
  request.profile = profile_option(context);
  request.json = context.options.format == Format::json;
  const auto duration = time_option(context, "--duration", context.options.duration);
  const auto assumed = time_option(context, "--assume-wcet", context.options.assume_wcet);
  if (duration) request.duration_ns = *duration;
  if (request.duration_ns > kLongestSimulation) {
    context.diagnostics
        .error(code::usage, {},
               fmt::format("--duration is too long: '{}'; every release of that time is simulated",
                           context.options.duration))
        .hint(fmt::format("write at most {}", units::format_duration(kLongestSimulation)));
  }
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  const auto question = read_question(context, assumed);
  if (!question) return finish(context, kExitInvalid);

  const bool is_traced = !context.options.out.empty();
  if (is_traced && !check_outputs({{context.options.out, "-o"}}, context.sources, context.diagnostics))
    return finish(context, kExitInvalid);
  std::optional<ReplacedFile> trace;
  if (is_traced) request.trace = &trace.emplace(context.options.out).stream();
  std::ostringstream result;
  const int status = run_simulate(question->model, request, context.diagnostics, result);
  if (trace && status != kExitInvalid) {
    const auto reason = trace->commit();
    if (reason) report_unwritten(context, context.options.out, *reason);
    if (reason) return finish(context, kExitInvalid);
  }
  return finish_analysis(context, status, result.str());
}

}  // namespace finemote::gen
