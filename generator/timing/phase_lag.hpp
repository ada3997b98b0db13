// How far the age of data turns a control loop: degrees at the frequency at which its gain is one.
#pragma once

#include <optional>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Degrees by which commands lag behind what they answer to, at most. A delay L turns a sine of frequency f by 360 f L
/// degrees; a value that is held for a period T lags by T / 2 in the mean, 180 f T degrees (Franklin, Powell, Workman,
/// Digital Control of Dynamic Systems, 3rd ed., 4.3.4: the phase of a zero-order hold).
struct PhaseLag {
  double age = 0;   ///< of the chain's end-to-end bound: from the sample to the command at the output
  double hold = 0;  ///< of the output, until its next command
  [[nodiscard]] double total() const { return age + hold; }
};

/// None where the chain has no end-to-end bound.
/// @param crossover_hz  above 0
std::optional<PhaseLag> phase_lag(const Model& model, const ChainResult& chain, double crossover_hz);

}  // namespace finemote::gen::timing
