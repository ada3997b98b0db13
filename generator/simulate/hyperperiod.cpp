#include "generator/simulate/hyperperiod.hpp"

#include <limits>
#include <numeric>

namespace finemote::gen {

std::optional<Duration> hyperperiod_of(const timing::Model& model) {
  std::int64_t all = 1;
  for (const timing::Device& device : model.devices) {
    const std::int64_t factor = device.period.ns() / std::gcd(all, device.period.ns());
    if (factor > std::numeric_limits<std::int64_t>::max() / all) return std::nullopt;
    all *= factor;
  }
  return nanoseconds(all);
}

}  // namespace finemote::gen
