// Periods to the time after which releases fall together as at the begin.
#pragma once

#include <optional>

#include "generator/timing/model.hpp"

namespace finemote::gen {

/// The least common multiple of the periods of all devices; none where it is longer than a Duration holds.
std::optional<Duration> hyperperiod_of(const timing::Model& model);

}  // namespace finemote::gen
