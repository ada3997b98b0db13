// How much execution times may grow before a deadline is missed.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/timing/result.hpp"

namespace finemote::gen::timing {

/// As slack_permille: nothing limits it.
inline constexpr std::int64_t kMostSlack = 1'000'000;

/// Largest factor, in thousandths, all execution times of devices (`only`: of one) can be multiplied with such that
/// every bucket of the profile still ends in its period; 0 when it does not even at 0; `kMostSlack` when nothing limits
/// it.
std::int64_t slack_permille(const Model& model, Profile profile, std::optional<Rank> only = std::nullopt);

/// Factors in thousandths, as of slack_permille.
struct Slack {
  std::int64_t all = 0;  ///< of all devices together
  Table<Rank, std::int64_t>
      one;  ///< of each device alone; empty for models of more than 500 devices: each takes a search
};

Slack find_slack(const Model& model, Profile profile);

}  // namespace finemote::gen::timing
