// Response times of every stage that hold for all releases: the fixed points of the paper's Lemma 2.
#pragma once

#include "generator/timing/demand.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

inline constexpr Duration kNone = nanoseconds(-1);  ///< no bound

/// Release to end, worst over all releases. kNone for every device of a bucket that is not ok: once a job may run over
/// its period, the first job of a busy interval need not be the worst one.
struct Responses {
  Table<Rank, Duration> b_plus, b_minus;  ///< own bucket's work up to the end of the stage
  Table<Rank, Duration> r_plus, r_minus;
  std::vector<Duration> bucket;   ///< end of a whole job; kNone above the period
  std::vector<bool> closed_form;  ///< of a bucket: the searches were given up, and what is there is not the least
  [[nodiscard]] bool ok(std::size_t w) const { return bucket[w] != kNone; }
};

/// Least fixed points of R = blocking + B + demand(R); a stage of zero length still has to be dispatched and ends at
/// fixed point (B + 1) - 1. Every search starts from the one before it. Where the steps are spent, a closed form
/// that is never smaller takes the place of the search. Throws Overflow.
Responses bound_responses(const TaskSet& set, Effort& effort);

}  // namespace finemote::gen::timing
