// finemote report: what is known of a robot as one page, to look at and to hand on.
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/run_file.hpp"
#include "generator/cli/subject.hpp"
#include "generator/diagnostic/clash.hpp"
#include "generator/report/page.hpp"
#include "generator/simulate/json.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing/remodel.hpp"

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
    return Answers{{timing::timing_json(*timing), simulation_json(*timing, run, request), nullptr},
                   recorder.timeline()};
  } catch (const Overflow& overflow) {
    timing::report_overflow(timing::start(model), overflow, findings);
    return std::nullopt;
  }
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
  if (diagnostics.has_errors()) return no_answer();
  if (!check_outputs({{options.out, "-o"}}, sources, diagnostics)) return no_answer();

  const auto& [library, robot, forest, schedule] = *subject->planned;
  question.remodel = timing::robot_remodel(robot, forest, robot_options);
  Answer answer;
  SimulationRequest request;
  request.profile = question.profile;
  auto answers = answers_of(subject->model, question, request, answer.judged);
  if (!answers) return answer;
  answers->documents.run = std::move(run);
  const report::Contents contents{view_of(robot, forest, schedule), subject->model, std::move(answers->documents),
                                  std::move(answers->timeline)};
  const std::string page = report::page_of(contents, input_of(options, diagnostics)->data_dir + "/templates/report");
  if (!write_result(options.out, page, diagnostics)) return no_answer();
  answer.status = denies_warnings(options, answer.judged) ? kExitInvalid : kExitYes;
  answer.text = "written: " + options.out + "\n";
  answer.document = {{"schema", "finemote.report/1"}, {"written", options.out}};
  return answer;
}

}  // namespace finemote::gen
