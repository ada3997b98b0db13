// How long a robot runs, where nobody says so.
#pragma once

#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Two hyperperiods, at least 100 ms and at most 1 s.
Duration default_duration(const Schedule& schedule);

}  // namespace finemote::gen
