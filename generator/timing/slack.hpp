// How much execution times may grow before a deadline is missed.
#pragma once

#include <vector>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Factors in thousandths, as of slack_permille.
struct Slack {
  std::int64_t all = 0;  ///< of all devices together
  Table<Rank, std::int64_t>
      one;  ///< of each device alone; empty for models of more than 500 devices: each takes a search
};

Slack find_slack(const Model& model, Profile profile);

}  // namespace finemote::gen::timing
