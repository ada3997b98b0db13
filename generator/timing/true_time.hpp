// What is calculated by the board's clock to the bounds that are stated, which are true time.
#pragma once

#include <optional>

#include "generator/timing/model.hpp"
#include "generator/units/clock_tolerance.hpp"

namespace finemote::gen::timing {

/// The longest true time of what the board counts as `counted` at most; none where there is no bound.
inline std::optional<Duration> true_bound(const Model& model, std::optional<Duration> counted) {
  return counted ? std::optional<Duration>(longest_time(*counted, model.clock_ppm)) : std::nullopt;
}

}  // namespace finemote::gen::timing
