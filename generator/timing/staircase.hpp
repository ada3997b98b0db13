// Monotone maps between the releases of a root and those of a device below it, and how they go on one edge further.
#pragma once

#include <vector>

#include "generator/timing/lags.hpp"

namespace finemote::gen::timing {

/// The steps of such a map in one repetition. Step k + n is step k one repetition later; both releases grow from step
/// to step.
///
/// Both directions are the recurrence of the paper's Theorem 3, walked from the root instead of from every terminal.
/// Down: the releases of the device in [device of the step before, device) see the decision of `root`. Up: the releases
/// of the root in (root of the step before, root] use the state of `device`. There are at most as many steps as the
/// slowest device on the way has releases.
struct Staircase {
  struct Step {
    std::int64_t root = 0;  ///< which release: 0 is the one at time 0
    Duration device;        ///< when
    friend bool operator==(const Step&, const Step&) = default;
  };
  Duration length = nanoseconds(1);  ///< of one repetition
  std::int64_t root_releases = 1;    ///< in it
  std::vector<Step> steps;
};

/// How many steps of `above` there are in `length`, a multiple of its own; a step further has at most as many.
std::int64_t steps_in(const Staircase& above, Duration length);

/// From the decisions a device sees to those a child of it sees.
/// @param length  of one repetition of the result: a multiple of `above.length`, of `period` and of what `lag` repeats
/// @param period  of the child
/// @param lag     of the device's decisions
Staircase step_down(const Staircase& above, Duration length, Duration period, LagCursor lag);

/// From the states of a device that the root uses to those of a child of it.
/// @param lag  of the child's states; the rest as above
Staircase step_up(const Staircase& above, Duration length, Duration period, LagCursor lag);

/// The terminal releases before `next` and not before that of the use before: they use the state of `source`.
struct TerminalUse {
  Duration next;
  Duration source;
};

/// Every use of one repetition, in ascending order: down to one device what came up from another (or from itself).
/// @param length  a multiple of the lengths of both, which belong to the same root
std::vector<TerminalUse> join(const Staircase& down, const Staircase& up, Duration length);

/// Largest next - source.
Duration oldest_age(const std::vector<TerminalUse>& uses);

}  // namespace finemote::gen::timing
