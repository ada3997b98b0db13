// Hyperperiods of buckets, and how many releases there are in them.
#pragma once

#include <optional>

#include "generator/timing/effort.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// Hyperperiod of a bucket and all higher-priority ones; none if 64 bits do not hold it.
std::optional<Duration> hyperperiod_to(const TaskSet& set, std::size_t bucket);

/// Releases of a bucket in that hyperperiod; none if 64 bits do not hold it.
std::optional<std::int64_t> releases_per_hyperperiod(const TaskSet& set, std::size_t bucket);

/// How many releases of one bucket, and of the root of one path, are examined: all that the limits allow where the
/// model as a whole is within them, else only a few.
std::int64_t most_releases(const TaskSet& set, const Limits& limits);

}  // namespace finemote::gen::timing
