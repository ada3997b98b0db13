// finemote analyze: bounds of a robot or a model, with the verdict.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/subject.hpp"
#include "generator/tasks/remodel.hpp"
#include "generator/timing/cost_labels.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing/phase_lag.hpp"
#include "generator/timing/reorder.hpp"
#include "generator/timing/slack.hpp"
#include "generator/timing/table.hpp"
#include "generator/timing/text_table.hpp"
#include "generator/timing/words.hpp"
#include "generator/timing_file/timing_file.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using timing::Json;

Json factor_json(std::int64_t permille) {
  return permille >= timing::kMostSlack ? Json(nullptr) : Json(static_cast<double>(permille) / 1000);
}

Json slack_json(const timing::Model& model, const timing::Slack& slack) {
  Json out{{"factor", factor_json(slack.all)}, {"devices", Json::array()}};
  for (const Rank d : slack.one.ids()) {
    out["devices"].push_back(Json{{"name", model.devices[d].name}, {"factor", factor_json(slack.one[d])}});
  }
  return out;
}

std::string factor_text(std::int64_t permille) {
  if (permille >= timing::kMostSlack) return "over 1000";
  return fmt::format("{}.{:03}", permille / 1000, permille % 1000);
}

std::string slack_text(const timing::Model& model, const timing::Slack& slack) {
  std::string text = fmt::format(
      "\nslack (factor on execution times up to which every bucket ends in its period)\n  all together  {}\n",
      factor_text(slack.all));
  if (slack.one.empty()) return text;
  timing::TextTable table({"device alone", "factor"});
  for (const Rank d : slack.one.ids()) table.row({model.devices[d].name, factor_text(slack.one[d])});
  return text + table.text();
}

std::string bounds_text(std::vector<std::string> head, const std::vector<timing::ChangedBound>& bounds) {
  timing::TextTable table(std::move(head));
  for (const timing::ChangedBound& bound : bounds)
    table.row({bound.what, timing::duration_text(bound.before), timing::duration_text(bound.after)});
  return table.text();
}

std::string order_text(const timing::Timing& timing, const timing::Order& order) {
  if (std::is_sorted(order.begin(), order.end())) return "\nno better order of siblings and roots was found\n";
  std::string text = "\nsuggested order of registration\n ";
  for (const Rank d : order) text += " " + timing.model.devices[d].name;
  const timing::OrderEffect effect = timing::effect_of_order(timing, order);
  return text + "\n" + bounds_text({"tree", "latency", "then"}, effect.trees) +
         bounds_text({"chain", "end to end", "then"}, effect.chains);
}

/// Into the chains of the document, each its own; null where it has no bound.
void add_phase_lags(const timing::Timing& timing, double crossover_hz, Json& document) {
  for (std::size_t i = 0; i < timing.chains.size(); ++i) {
    Json& member = document["chains"][i]["phase_lag"] = Json(nullptr);
    const auto lag = timing::phase_lag(timing.model, timing.chains[i], crossover_hz);
    if (lag)
      member = {
          {"crossover_hz", crossover_hz}, {"age_deg", lag->age}, {"hold_deg", lag->hold}, {"total_deg", lag->total()}};
  }
}

std::string phase_text(const timing::Timing& timing, double crossover_hz) {
  timing::TextTable table({"chain", "age", "hold", "together"});
  const auto degrees = [](double value) { return fmt::format("{:.1f}", value); };
  for (const timing::ChainResult& chain : timing.chains) {
    const std::string name = timing.model.devices[chain.from].name + " -> " + timing.model.devices[chain.to].name;
    const auto lag = timing::phase_lag(timing.model, chain, crossover_hz);
    if (lag)
      table.row({name, degrees(lag->age), degrees(lag->hold), degrees(lag->total())});
    else
      table.row({name, "-", "-", "-"});
  }
  return fmt::format("\nphase lag at {} Hz [degrees], at most\n", crossover_hz) + table.text();
}

/// The value of --crossover [Hz]; none where it is not given, or wrong: then FM0001 is reported.
std::optional<double> crossover_option(const std::string& text, Diagnostics& diagnostics) {
  constexpr std::string_view kUnit = "Hz";
  constexpr double kMostHz = 1e6;
  if (text.empty()) return std::nullopt;
  const auto parsed = units::parse_real(text, kUnit);
  if (parsed && *parsed > 0 && *parsed <= kMostHz && text.ends_with(kUnit)) return *parsed;
  diagnostics
      .error(code::usage, {},
             fmt::format("--crossover must be a frequency in Hz, above 0 and up to {:.0f}, got '{}'", kMostHz, text))
      .hint("write for example --crossover 2Hz");
  return std::nullopt;
}

/// What the options ask for beside the analysis.
struct Extras {
  std::optional<double> crossover_hz;
  std::optional<timing::Slack> slack;
  std::optional<timing::Order> order;
};

Json document(const timing::Timing& timing, const Extras& extras) {
  Json document = timing::timing_json(timing);
  if (extras.crossover_hz) add_phase_lags(timing, *extras.crossover_hz, document);
  if (extras.slack) document["slack"] = slack_json(timing.model, *extras.slack);
  if (extras.order) {
    for (const Rank d : *extras.order) document["suggested_order"].push_back(timing.model.devices[d].name);
  }
  return document;
}

std::string text(const timing::Timing& timing, const Extras& extras) {
  std::string text = timing::timing_table(timing);
  if (extras.crossover_hz) text += phase_text(timing, *extras.crossover_hz);
  if (extras.slack) text += slack_text(timing.model, *extras.slack);
  if (extras.order) text += order_text(timing, *extras.order);
  return text;
}

/// What runs beside the stages and is not charged a bound of the image.
std::vector<std::string> costs_not_static(const timing::Model& model) {
  std::vector<std::string> list;
  for (const timing::CostLabel& cost : timing::cost_labels(model)) {
    if (cost.source != timing::WcetSource::computed) list.push_back(cost.what);
  }
  return list;
}

/// FM4025 for each device whose execution times were not computed, and for what runs beside the stages.
/// @return  whether there is none
/// @param input  what was analysed
bool report_not_static(const timing::Model& model, const std::string& input, Diagnostics& judged) {
  const std::string file = timing_file_path(input);
  bool is_static = true;
  for (const timing::Device& device : model.devices) {
    if (device.source == timing::WcetSource::computed) continue;
    is_static = false;
    judged
        .error(
            code::timing_not_static, device.at,
            fmt::format("the execution times of '{}' are {}, not static", device.name, timing::label_of(device.source)))
        .hint(file.empty() ? "only of a robot in a file can they be computed"
                           : fmt::format("compute them: finemote wcet {} -o {}", input, file));
  }
  const std::vector<std::string> others = costs_not_static(model);
  if (!is_static || others.empty()) return is_static;  // who computes those of the stages gets these as well
  judged
      .error(code::timing_not_static, timing::at_first_device(model),
             fmt::format("what the scheduler and the interrupts take is not static: {}", fmt::join(others, ", ")))
      .note("they are missing if anything in the image has no bound, or if the timing file is from an older version");
  return false;
}

}  // namespace

Answer run_analyze(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  timing::AnalysisRequest request;
  request.profile = profile_option(options.profile, diagnostics);
  timing::RobotTimingOptions robot_options;
  robot_options.trace = options.trace;
  robot_options.monitor = options.monitor;
  robot_options.assumed_wcet = time_option("--assume-wcet", options.assume_wcet, "50us", diagnostics);
  Extras extras;
  extras.crossover_hz = crossover_option(options.crossover, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  if (options.dump) return dump_subject(options, robot_options, sources, diagnostics);
  const auto subject = read_subject(options, robot_options, sources, diagnostics);
  if (!subject) return no_answer();

  const timing::Model& model = subject->model;
  request.chains = timing::parse_chains(model, options.chains, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  request.requirements = subject->requirements;
  request.remodel = subject->planned
                        ? timing::robot_remodel(subject->planned->robot, subject->planned->forest, robot_options)
                        : timing::model_remodel(model);
  Answer answer;
  const auto timing = timing::analyse(model, request, answer.judged);
  if (!timing) return answer;
  if (options.slack) extras.slack = timing::find_slack(model, timing->asked);
  if (options.suggest_order) extras.order = timing::suggest_order(model, timing->asked);
  if (options.format == Format::json) answer.document = document(*timing, extras);
  if (options.format == Format::text) answer.text = text(*timing, extras);
  const bool is_static = !options.require_static || report_not_static(timing->model, options.input, answer.judged);
  const bool is_yes = timing->schedulable && timing->requirements_hold() && is_static;
  answer.status = !is_yes ? kExitNo : denies_warnings(options, answer.judged) ? kExitInvalid : kExitYes;
  return answer;
}

}  // namespace finemote::gen
