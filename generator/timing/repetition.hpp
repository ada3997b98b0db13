// When several periods are in phase again, and how many releases there are until then.
#pragma once

#include <optional>

#include "generator/timing/effort.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// Least common multiple of two times above 0; none where it leaves 64 bits, which is longer than any analysis looks.
std::optional<Duration> common_multiple(std::optional<Duration> a, std::optional<Duration> b);

/// How long it takes until a bucket and all higher-priority ones repeat; none where 64 bits do not hold that.
std::optional<Duration> time_until_repeat(const TaskSet& set, std::size_t bucket);

/// Releases of a bucket until it and all higher-priority ones repeat; none where 64 bits do not hold that time.
std::optional<std::int64_t> releases_until_repeat(const TaskSet& set, std::size_t bucket);

/// How many releases of one bucket, and of the root of one path, are examined: all that the limits allow where the
/// model as a whole is within them, else only a few.
std::int64_t most_releases(const TaskSet& set, const Limits& limits);

}  // namespace finemote::gen::timing
