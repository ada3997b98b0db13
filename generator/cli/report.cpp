// finemote report: what is known of a robot as one page, to look at and to hand on.
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/run_bounds.hpp"
#include "generator/cli/saved_document.hpp"
#include "generator/cli/subject.hpp"
#include "generator/diagnostic/clash.hpp"
#include "generator/input/input.hpp"
#include "generator/report/page.hpp"
#include "generator/simulate/json.hpp"
#include "generator/tasks/remodel.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing_file/user_code.hpp"

namespace finemote::gen {
namespace {

/// The bounds, a simulated run beside them, and what happens at its begin.
struct Answers {
  report::Documents documents;
  report::Timeline timeline;
};

std::optional<Answers> answers_of(const timing::Model& model, const timing::AnalysisRequest& question,
                                  const SimulationRequest& request, Diagnostics& findings) {
  const auto timing = timing::analyse(model, question, findings);
  if (!timing) return std::nullopt;
  try {
    const SimulationOptions options = options_beside(*timing, request);
    report::TimelineRecorder recorder(model, options.profile);
    const Simulation run = simulate(model, options, &recorder);
    return Answers{{timing::timing_json(*timing), simulation_json(*timing, run, request), nullptr, nullptr},
                   recorder.timeline()};
  } catch (const Overflow& overflow) {
    timing::report_overflow(timing::at_first_device(model), overflow, findings);
    return std::nullopt;
  }
}

/// The analysis to compare with: saved, or of another robot, made here. Null where diagnostics hold why there is none.
report::Json earlier_timing(const Options& options, const timing::RobotTimingOptions& robot_options,
                            const timing::AnalysisRequest& question, Sources& sources, Diagnostics& diagnostics) {
  if (options.against.empty()) return nullptr;
  if (is_timing_model(options.against)) return read_timing(options.against, sources, diagnostics);
  Options before = options;
  before.input = options.against;
  const auto subject = read_subject(before, robot_options, sources, diagnostics);
  if (!subject) return nullptr;
  timing::AnalysisRequest request;
  request.profile = question.profile;
  request.requirements = subject->requirements;
  Diagnostics findings;  // of that robot: not what this report is about
  const auto timing = timing::analyse(subject->model, request, findings);
  if (!timing) add_findings(findings, diagnostics);
  return timing ? timing::timing_json(*timing) : report::Json(nullptr);
}

}  // namespace

Answer run_report(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  timing::AnalysisRequest question;
  question.profile = profile_option(options.profile, diagnostics);
  timing::RobotTimingOptions robot_options;
  robot_options.assumed_wcet = time_option("--assume-wcet", options.assume_wcet, "50us", diagnostics);
  if (is_timing_model(options.input))
    diagnostics.error(code::usage, {}, "a report is of a robot: a .urdf or .xacro file, not a timing model")
        .hint("for a timing model there are 'analyze' and 'simulate'");
  if (diagnostics.has_errors()) return no_answer();
  const auto subject = read_subject(options, robot_options, sources, diagnostics);
  if (!subject) return no_answer();
  question.chains = timing::parse_chains(subject->model, options.chains, diagnostics);
  question.requirements = subject->requirements;
  report::Json run;
  if (!options.run_file.empty()) run = read_run(options.run_file, subject->model, sources, diagnostics);
  report::Json against = earlier_timing(options, robot_options, question, sources, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  if (!check_results({{options.out, "-o"}}, sources, diagnostics,
                     user_files(subject->planned->robot, sources.access())))
    return no_answer();

  const auto& [robot, forest, schedule] = subject->planned->plan();
  question.remodel = timing::robot_remodel(robot, forest, robot_options);
  Answer answer;
  SimulationRequest request;
  request.profile = question.profile;
  auto answers = answers_of(subject->model, question, request, answer.judged);
  if (!answers) return answer;
  check_bounds_of_run(run, options.run_file, answers->documents.timing, answer.judged);
  answers->documents.run = std::move(run);
  answers->documents.against = std::move(against);
  const report::Contents contents{view_of(robot, forest, schedule), report::body_of(robot), subject->model,
                                  std::move(answers->documents), std::move(answers->timeline)};
  const std::string page = report::page_of(contents, input_of(options, diagnostics)->data_dir + "/templates/report");
  if (!write_result(options.out, page, diagnostics)) return no_answer();
  answer.status = denies_warnings(options, answer.judged) ? kExitInvalid : kExitYes;
  answer.text = "written: " + options.out + "\n";
  answer.document = {{"schema", "finemote.report/1"}, {"written", options.out}};
  return answer;
}

}  // namespace finemote::gen
