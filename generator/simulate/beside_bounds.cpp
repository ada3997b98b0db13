#include "generator/simulate/beside_bounds.hpp"

#include "generator/simulate/trace.hpp"
#include "generator/timing/operands.hpp"

namespace finemote::gen {
namespace {

bool above(std::optional<Duration> value, std::optional<Duration> bound) { return value && bound && *value > *bound; }

Simulation simulate_traced(const timing::Model& model, const SimulationOptions& options, std::ostream* trace) {
  if (trace == nullptr) return simulate(model, options);
  TraceWriter writer(model, options.profile, *trace);
  Simulation run = simulate(model, options, &writer);
  writer.close();
  return run;
}

}  // namespace

SimulationOptions options_beside(const timing::Timing& timing, const SimulationRequest& request) {
  const bool as_paper = timing.asked == timing::Profile::paper;
  SimulationOptions options{request.seed, request.duration, as_paper ? timing::Profile::tight : timing.asked, {}};
  for (const timing::ChainResult& chain : timing.chains) options.chains.push_back({chain.from, chain.to});
  return options;
}

std::optional<Duration> observed(Duration worst) {
  return worst < Duration::zero() ? std::nullopt : std::optional(worst);
}

bool SimulatedModel::holds() const {
  const auto& bounds = timing.verdict().devices;
  for (const Rank d : bounds.ids()) {
    if (above(observed(run.devices[d].response), bounds[d].r_minus)) return false;
    if (above(observed(run.devices[d].window), bounds[d].window)) return false;
  }
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    if (above(observed(run.chains[c].latency), timing.chains[c].decide)) return false;
  }
  return true;
}

std::optional<SimulatedModel> simulate_beside_bounds(const timing::Model& model, const SimulationRequest& request,
                                                     Diagnostics& diagnostics, std::ostream* trace) {
  timing::AnalysisRequest question;
  question.profile = request.profile;
  question.chains = timing::parse_chains(model, request.chains, diagnostics);
  question.requirements = request.requirements;
  question.chains_alone = true;
  if (diagnostics.has_errors()) return std::nullopt;
  auto timing = timing::analyse(model, question, diagnostics);
  if (!timing) return std::nullopt;
  try {
    Simulation run = simulate_traced(model, options_beside(*timing, request), trace);
    return SimulatedModel{std::move(*timing), std::move(run)};
  } catch (const Overflow& overflow) {
    timing::report_overflow(timing::at_first_device(model), overflow, diagnostics);
    return std::nullopt;
  }
}

}  // namespace finemote::gen
