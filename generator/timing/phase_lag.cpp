#include "generator/timing/phase_lag.hpp"

namespace finemote::gen::timing {
namespace {

constexpr double kTurn = 360;  ///< degrees

double turns(Duration time, double hz) { return static_cast<double>(time.ns()) * 1e-9 * hz; }

}  // namespace

std::optional<PhaseLag> phase_lag(const Model& model, const ChainResult& chain, double crossover_hz) {
  if (!chain.end_to_end) return std::nullopt;
  return PhaseLag{kTurn * turns(*chain.end_to_end, crossover_hz),
                  kTurn / 2 * turns(model.devices[chain.to].period, crossover_hz)};
}

}  // namespace finemote::gen::timing
