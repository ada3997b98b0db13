// How long a robot runs, where nobody says so.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Least common multiple of the periods [ns]; none beyond `limit`.
std::optional<std::int64_t> hyperperiod(const Schedule& schedule, std::int64_t limit);

/// Two hyperperiods [ns], at least 100 ms and at most 1 s.
std::int64_t default_duration(const Schedule& schedule);

}  // namespace finemote::gen
