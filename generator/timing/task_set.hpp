// Model and profile to what the fixed points work on: interrupt streams, buckets and stage costs.
#pragma once

#include <vector>

#include "generator/timing/model.hpp"
#include "generator/timing/result.hpp"

namespace finemote::gen::timing {

/// Interrupts of one source in any window of length L: at most ceil(L/separation) and, with budgets, at most
/// sum count * (ceil(L/period) + carry_in).
struct Stream {
  struct Budget {
    Ns count = 0;
    Ns period = 1;
    Ns carry_in = 0;
  };
  Ns separation = 1;
  Ns cost = 0;
  std::vector<Budget> budgets;
};

struct TaskBucket {
  Ns period = 1;
  Ns before = 0;                     ///< entry of a job, ahead of the first update
  Ns after = 0;                      ///< flush and exit, behind the last handle
  Ns cost = 0;                       ///< one whole job
  std::vector<std::size_t> devices;  ///< registration order
};

/// Streams run above all buckets, shorter periods above longer ones.
struct TaskSet {
  std::vector<Stream> streams;         ///< of nonzero cost
  std::vector<TaskBucket> buckets;     ///< ascending period
  std::vector<std::size_t> bucket_of;  ///< per device
  std::vector<Ns> update, handle;      ///< per device: one run of the stage with everything around it
  Ns blocking = 0;                     ///< longest masked section: delays every busy window once
};

/// Requires a model that read_model accepts. May throw Overflow.
TaskSet make_task_set(const Model& model, Profile profile);

}  // namespace finemote::gen::timing
