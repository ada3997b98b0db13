// The chains of a robot, measured on a run beside their bounds.
#pragma once

#include <vector>

#include "generator/run/measure.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

/// One figure of a chain.
struct Measured {
  Statistics observed;
  std::optional<Duration> bound;

  [[nodiscard]] bool holds() const { return !bound || observed.count == 0 || observed.max <= *bound; }
};

struct MeasuredChain {
  DeviceId from, to;
  Measured acquire, decide, wire, end_to_end;

  [[nodiscard]] bool holds() const { return acquire.holds() && decide.holds() && wire.holds() && end_to_end.holds(); }
};

/// Measures the chains of `timing` (whose devices are in the order of `forest`). Acquire and wire need parts that say
/// when they sampled and when an output changed: on the emulated board. Wire has a sample where the output changed.
std::vector<MeasuredChain> measure_chains(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record);

}  // namespace finemote::gen
