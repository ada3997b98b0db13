#include "generator/simulate/beside_bounds.hpp"

#include "generator/simulate/trace.hpp"
#include "generator/timing/operands.hpp"

namespace finemote::gen {
namespace {

using timing::Ns;

bool above(std::optional<Ns> value, std::optional<Ns> bound) { return value && bound && *value > *bound; }

}  // namespace

std::optional<Ns> observed(Ns worst) { return worst < 0 ? std::nullopt : std::optional<Ns>(worst); }

bool SimulatedModel::holds() const {
  const auto& bounds = timing.verdict().devices;
  for (const Rank d : bounds.ids()) {
    if (above(observed(run.devices[d].response), bounds[d].r_minus_ns)) return false;
    if (above(observed(run.devices[d].window), bounds[d].window_ns)) return false;
  }
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    if (above(observed(run.chains[c].latency), timing.chains[c].decide_ns)) return false;
  }
  return true;
}

std::optional<SimulatedModel> simulate_beside_bounds(const timing::Model& model, const SimulationRequest& request,
                                                     Diagnostics& diagnostics, std::ostream* trace) {
  timing::AnalysisRequest question;
  question.profile = request.profile;
  question.chains = timing::parse_chains(model, request.chains, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  auto timing = timing::analyse(model, question, diagnostics);
  if (!timing) return std::nullopt;
  const bool as_paper = timing->asked == timing::Profile::paper;
  SimulationOptions options{request.seed, request.duration_ns, as_paper ? timing::Profile::tight : timing->asked, {}};
  for (const timing::ChainResult& chain : timing->chains) options.chains.push_back({chain.from, chain.to});
  std::optional<TraceWriter> writer;
  if (trace != nullptr) writer.emplace(model, options.profile, *trace);
  Simulation run = simulate(model, options, writer ? &*writer : nullptr);
  if (writer) writer->close();
  return SimulatedModel{std::move(*timing), std::move(run)};
}

}  // namespace finemote::gen
