// Figures of documents beside their bounds. To nlohmann null is below every number, so `figure <= bound` of values also
// holds of what was not measured.
#pragma once

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace finemote::test {

/// The figure was measured, is positive, and is no larger than its bound.
inline void check_bound(const nlohmann::json& largest, const nlohmann::json& bound) {
  CHECK(largest.get<std::int64_t>() > 0);
  CHECK(largest.get<std::int64_t>() <= bound.get<std::int64_t>());
}

/// There are stages, each of them ran and took no longer by itself than its WCET, and not all are empty.
inline void check_own_times(const nlohmann::json& run) {
  REQUIRE(!run["stages"].empty());
  std::int64_t longest = 0;
  for (const nlohmann::json& stage : run["stages"]) {
    INFO(stage.dump());
    CHECK(stage["count"].get<std::int64_t>() > 0);
    const auto own = stage["own_max_ns"].get<std::int64_t>();  // 0 where the compiler finds nothing to do
    CHECK(own <= stage["wcet_ns"].get<std::int64_t>());
    longest = std::max(longest, own);
  }
  CHECK(longest > 0);
}

}  // namespace finemote::test
