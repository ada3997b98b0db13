#include "generator/simulate/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "generator/diagnostic/render.hpp"
#include "generator/simulate/trace.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing/table.hpp"

namespace finemote::gen {
namespace {

using timing::duration_text;
using timing::Json;
using timing::Ns;

std::optional<Ns> seen(Ns value) { return value < 0 ? std::nullopt : std::optional<Ns>(value); }

bool above(std::optional<Ns> value, std::optional<Ns> bound) { return value && bound && *value > *bound; }

/// What was observed, with the bounds it must not exceed.
struct Outcome {
  const timing::Timing& timing;
  const Simulation& run;

  [[nodiscard]] bool holds() const {
    const auto& bounds = timing.verdict().devices;
    for (std::size_t d = 0; d < bounds.size(); ++d) {
      if (above(seen(run.devices[d].response), bounds[d].r_minus_ns)) return false;
      if (above(seen(run.devices[d].window), bounds[d].window_ns)) return false;
    }
    for (std::size_t c = 0; c < run.chains.size(); ++c) {
      if (above(seen(run.chains[c].latency), timing.chains[c].decide_ns)) return false;
    }
    return true;
  }
};

Json number(std::optional<Ns> value) { return value ? Json(*value) : Json(nullptr); }

Json document(const Outcome& outcome, const SimulateOptions& options) {
  const auto& [timing, run] = outcome;
  const auto& bounds = timing.verdict().devices;
  Json out{{"schema", "finemote.simulation/1"},
           {"profile", timing::profile_name(timing.asked)},
           {"seed", options.seed},
           {"duration_ns", options.duration_ns},
           {"devices", Json::array()},
           {"chains", Json::array()},
           {"misses", run.misses}};
  for (std::size_t d = 0; d < run.devices.size(); ++d) {
    out["devices"].push_back(Json{{"name", timing.model.devices[d].name},
                                  {"response_max_ns", number(seen(run.devices[d].response))},
                                  {"window_max_ns", number(seen(run.devices[d].window))},
                                  {"response_bound_ns", number(bounds[d].r_minus_ns)},
                                  {"window_bound_ns", number(bounds[d].window_ns)}});
  }
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    out["chains"].push_back(Json{{"from", timing.model.devices[run.chains[c].ends.from].name},
                                 {"to", timing.model.devices[run.chains[c].ends.to].name},
                                 {"max_ns", number(seen(run.chains[c].latency))},
                                 {"bound_ns", number(timing.chains[c].decide_ns)}});
  }
  return out;
}

std::string table(const Outcome& outcome, const SimulateOptions& options) {
  const auto& [timing, run] = outcome;
  const auto& bounds = timing.verdict().devices;
  std::string text =
      fmt::format("simulated {} with seed {} (profile {}): {} missed\n", duration_text(options.duration_ns),
                  options.seed, timing::profile_name(timing.asked), run.misses);
  timing::Table devices({"device", "response", "bound", "window", "bound"});
  for (std::size_t d = 0; d < run.devices.size(); ++d) {
    devices.row({timing.model.devices[d].name, duration_text(seen(run.devices[d].response)),
                 duration_text(bounds[d].r_minus_ns), duration_text(seen(run.devices[d].window)),
                 duration_text(bounds[d].window_ns)});
  }
  timing::Table chains({"chain (decide)", "worst", "bound"});
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    chains.row(
        {timing.model.devices[run.chains[c].ends.from].name + " -> " + timing.model.devices[run.chains[c].ends.to].name,
         duration_text(seen(run.chains[c].latency)), duration_text(timing.chains[c].decide_ns)});
  }
  text += "\ndevices\n" + devices.text() + "\nchains\n" + chains.text();
  if (!outcome.holds()) text += "\nan observation exceeds its bound: please report this model\n";
  return text;
}

}  // namespace

int run_simulate(const timing::Model& model, const SimulateOptions& options, Diagnostics& diagnostics,
                 std::ostream& out) {
  timing::AnalysisRequest request;
  request.profile = options.profile;
  request.chains = timing::parse_chains(model, options.chains, diagnostics);
  if (diagnostics.has_errors()) return 2;
  const std::optional<timing::Timing> timing = timing::analyse(model, request, diagnostics);
  if (!timing) return 2;
  // The paper's buses interrupt more often than any wire can; what happens is what profile tight describes.
  const bool as_paper = timing->asked == timing::Profile::paper;
  SimulationOptions run{options.seed, options.duration_ns, as_paper ? timing::Profile::tight : timing->asked, {}};
  for (const timing::ChainResult& c : timing->chains) run.chains.push_back({c.from, c.to});
  std::optional<TraceWriter> trace;
  if (options.trace != nullptr) trace.emplace(model, run.profile, *options.trace);
  const Simulation result = simulate(model, run, trace ? &*trace : nullptr);
  if (trace) trace->close();
  const Outcome outcome{*timing, result};
  if (options.json) {
    Json json = document(outcome, options);
    json["diagnostics"] = render_json(diagnostics);
    out << json.dump(2) << '\n';
  } else {
    out << table(outcome, options);
  }
  return timing->schedulable && result.misses == 0 && outcome.holds() ? 0 : 1;
}

}  // namespace finemote::gen
