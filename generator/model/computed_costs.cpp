#include "generator/model/computed_costs.hpp"

#include <algorithm>

namespace finemote::gen {

Duration ComputedCosts::behind_jobs(Duration period) const {
  const auto found = behind.find(period);
  if (found != behind.end()) return found->second;
  Duration longest;
  for (const auto& [other, duration] : behind) longest = std::max(longest, duration);
  return longest;
}

}  // namespace finemote::gen
