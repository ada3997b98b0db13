// finemote simulate: a run of the schedule with random execution times, beside its bounds.
#include <fmt/format.h>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/subject.hpp"
#include "generator/diagnostic/clash.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/simulate/json.hpp"
#include "generator/timing/table.hpp"
#include "generator/timing/text_table.hpp"
#include "generator/timing_file/user_code.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using timing::duration_text;

std::string text(const SimulatedModel& simulated, const SimulationRequest& request) {
  const auto& [timing, run] = simulated;
  const auto& bounds = timing.verdict().devices;
  std::string text = fmt::format("simulated {} with seed {} (profile {}): {} missed\n", duration_text(run.duration),
                                 request.seed, timing::profile_name(timing.asked), run.misses);
  if (run.duration < request.duration) {
    text += fmt::format("the run ended early: there is more to do in {} than one run takes\n",
                        duration_text(request.duration));
  }
  timing::TextTable devices({"device", "response", "bound", "window", "bound"});
  for (const Rank d : run.devices.ids()) {
    devices.row({timing.model.devices[d].name, duration_text(observed(run.devices[d].response)),
                 duration_text(bounds[d].r_minus), duration_text(observed(run.devices[d].window)),
                 duration_text(bounds[d].window)});
  }
  timing::TextTable chains({"chain (decide)", "worst", "bound"});
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    chains.row(
        {timing.model.devices[run.chains[c].ends.from].name + " -> " + timing.model.devices[run.chains[c].ends.to].name,
         duration_text(observed(run.chains[c].latency)), duration_text(timing.chains[c].decide)});
  }
  text += "\ndevices\n" + devices.text() + "\nchains\n" + chains.text();
  if (!simulated.holds()) text += "\nan observation exceeds its bound: please report this model\n";
  return text;
}

SimulationRequest request_of(const Options& options, Diagnostics& diagnostics) {
  SimulationRequest request;
  request.seed = options.seed;
  request.chains = options.chains;
  request.profile = profile_option(options.profile, diagnostics);
  const auto duration = duration_option(options, "50us", "release", diagnostics);
  if (duration) request.duration = *duration;
  return request;
}

}  // namespace

Answer run_simulate(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  SimulationRequest request = request_of(options, diagnostics);
  timing::RobotTimingOptions robot_options;
  robot_options.assumed_wcet = time_option("--assume-wcet", options.assume_wcet, "50us", diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  if (options.dump) return dump_subject(options, robot_options, sources, diagnostics);
  const auto subject = read_subject(options, robot_options, sources, diagnostics);
  if (!subject) return no_answer();
  request.requirements = subject->requirements;

  const bool is_traced = !options.out.empty();
  const auto read =
      subject->planned ? user_files(subject->planned->robot, sources.access()) : std::vector<std::string>();
  if (!check_results({{options.out, "-o"}}, sources, diagnostics, read)) return no_answer();
  std::optional<ReplacedFile> trace;
  if (is_traced) trace.emplace(options.out);
  Answer answer;
  const auto simulated =
      simulate_beside_bounds(subject->model, request, answer.judged, trace ? &trace->stream() : nullptr);
  if (!simulated) return answer;
  if (trace) {
    const auto reason = trace->commit();
    if (reason) report_unwritten(options.out, *reason, diagnostics);
    if (reason) return answer;
  }
  if (options.format == Format::json) answer.document = simulation_json(simulated->timing, simulated->run, request);
  if (options.format == Format::text) answer.text = text(*simulated, request);
  answer.status = !simulated->good() ? kExitNo : denies_warnings(options, answer.judged) ? kExitInvalid : kExitYes;
  return answer;
}

}  // namespace finemote::gen
