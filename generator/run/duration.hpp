// How long a robot runs, where nobody says so.
#pragma once

#include <optional>

#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Least common multiple of the periods; none beyond `limit`.
std::optional<Duration> hyperperiod(const Schedule& schedule, Duration limit);

/// Two hyperperiods, at least 100 ms and at most 1 s.
Duration default_duration(const Schedule& schedule);

}  // namespace finemote::gen
