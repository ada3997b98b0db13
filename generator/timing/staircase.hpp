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
    Ns root = 0;    ///< which release: 0 is the one at time 0
    Ns device = 0;  ///< when
    friend bool operator==(const Step&, const Step&) = default;
  };
  Ns length = 1;         ///< of one repetition
  Ns root_releases = 1;  ///< in it
  std::vector<Step> steps;
};

/// How many steps of `above` there are in `length`, a multiple of its own; at most so many has a step further.
Ns steps_in(const Staircase& above, Ns length);

/// From the decisions a device sees to those a child of it sees.
/// @param length  of one repetition of the result: a multiple of `above.length`, of `period` and of what `lag` repeats
/// @param period  of the child
/// @param lag     of the device's decisions
Staircase step_down(const Staircase& above, Ns length, Ns period, LagCursor lag);

/// From the states of a device that the root uses to those of a child of it.
/// @param lag  of the child's states; the rest as above
Staircase step_up(const Staircase& above, Ns length, Ns period, LagCursor lag);

/// The terminal releases before `next` and not before that of the use before: they use the state of `source`.
struct TerminalUse {
  Ns next = 0;
  Ns source = 0;
};

/// Every use of one repetition, in ascending order: down to one device what came up from another (or from itself).
/// @param length  a multiple of the lengths of both, which belong to the same root
std::vector<TerminalUse> join(const Staircase& down, const Staircase& up, Ns length);

/// Largest next - source.
Ns oldest_age(const std::vector<TerminalUse>& uses);

}  // namespace finemote::gen::timing
