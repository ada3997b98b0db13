// The chains of a robot, measured on a run beside their bounds.
#pragma once

#include <array>
#include <vector>

#include "generator/run/measure.hpp"
#include "generator/run/measured.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

/// A command when it took effect: at the last bit of its output where that and the sample behind it are known, else at
/// the end of its handle().
struct MeasuredAge {
  Duration at;   ///< since the first release
  Duration age;  ///< of its data: end to end, else of the decision alone
};

/// One chain: samples to update() (acquire), to handle() (decide), to the output (wire), and in all.
struct MeasuredChain {
  DeviceId from, to;
  Measured acquire, decide, wire, end_to_end;
  bool has_wire = true;                ///< the command goes on from its last device; else wire has no sample
  bool is_listed = true;               ///< analyze lists it, or was asked for it
  std::vector<MeasuredAge> ages = {};  ///< of one run, in time order; end to end where that has samples
};

inline constexpr std::array<Figure<MeasuredChain>, 4> kChainFigures{{{"acquire", &MeasuredChain::acquire},
                                                                     {"decide", &MeasuredChain::decide},
                                                                     {"wire", &MeasuredChain::wire},
                                                                     {"end to end", &MeasuredChain::end_to_end}}};

/// Measures the chains of `timing`, listed and others (whose devices are in the order of `forest`). Acquire and wire
/// need parts that say when they sampled and when an output changed: on the emulated board. Wire has a sample where the
/// output changed.
/// @param is_bound  the bounds hold for what ran; else the chains have none
std::vector<MeasuredChain> measure_chains(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record, const StageRuns& runs, bool is_bound);

/// Leaves out chains that are not listed, but for those that are above a bound, and one for each actuator that no
/// listed one ends at: that with the largest bound.
void leave_out_others(const Robot& robot, std::vector<MeasuredChain>& chains);

}  // namespace finemote::gen
