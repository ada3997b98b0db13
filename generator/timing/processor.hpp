// Who uses the processor, and for how much of it, in the long run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// One part of the processor's load.
struct ProcessorUse {
  enum class Kind { bucket, flush, interrupt, dma, release };
  Kind kind = Kind::bucket;
  std::string name;  ///< bucket: its period; flush: its output, bus or first device; interrupt, dma: the bus; `release`
  std::string source;               ///< interrupt: which of the bus; empty where it has one, and for the other kinds
  Duration cost;                    ///< of one, exception entry and exit included
  Duration every = nanoseconds(1);  ///< period of the bucket, or least distance of two interrupts
  double utilization = 0;  ///< long-run share of the processor, 0 and more; budgets counted where they are slower
};

/// `bucket`, `flush`, `interrupt`, `dma`, `release`.
std::string_view kind_name(ProcessorUse::Kind kind);

/// `devices every 10ms`, `'rx' interrupts of bus 'link'`: one user of the processor, for people.
std::string user_text(const ProcessorUse& use);

/// Every bucket (without its flushes), flush, interrupt source and the release interrupt of a profile's task set,
/// largest load first; those without load are left out. Their sum is processor_share(set), but for rounding.
std::vector<ProcessorUse> processor_use(const Model& model, const TaskSet& set);

/// Share of the processor all streams and buckets take in the long run, 0 and more.
double processor_share(const TaskSet& set);

}  // namespace finemote::gen::timing
