#include "generator/timing/hand_over.hpp"

#include <algorithm>

namespace finemote::gen::timing {

Duration oldest_down(const Staircase& down, Duration period, Duration root_period) {
  Duration oldest;
  for (const Staircase::Step& step : down.steps) {
    oldest = std::max(oldest, step.device - period - step.root * root_period);
  }
  return oldest;
}

Duration oldest_up(const Staircase& up, Duration root_period) {
  Duration oldest;
  for (const Staircase::Step& step : up.steps) oldest = std::max(oldest, step.root * root_period - step.device);
  return oldest;
}

ClosedForm closed_form_of(const HandOver& exact, Duration period, Duration root_period) {
  const Duration age = oldest_age(join(*exact.down, *exact.up, exact.length)) - period;
  return {std::max(Duration::zero(), age), oldest_down(*exact.down, period, root_period),
          oldest_up(*exact.up, root_period)};
}

ClosedForm one_edge_below(const ClosedForm& above, Duration parent_period, Duration period, const Lags& down,
                          const Lags& up) {
  const Duration common = gcd(period, parent_period);
  const Duration further_down = parent_period - common + down.most;
  const Duration further_up = period - common + up.most;
  return {above.age + further_down + further_up, above.down + further_down, above.up + further_up};
}

}  // namespace finemote::gen::timing
