#include "generator/timing/hand_over.hpp"

#include <algorithm>

namespace finemote::gen::timing {

ClosedForm closed_form_of(const HandOver& exact, Duration period, Duration root_period) {
  ClosedForm closed;
  closed.age = std::max(Duration::zero(), oldest_age(join(*exact.down, *exact.up, exact.length)) - period);
  for (const Staircase::Step& step : exact.down->steps) {
    closed.down = std::max(closed.down, step.device - period - step.root * root_period);
  }
  for (const Staircase::Step& step : exact.up->steps) {
    closed.up = std::max(closed.up, step.root * root_period - step.device);
  }
  return closed;
}

ClosedForm one_edge_below(const ClosedForm& above, Duration parent_period, Duration period, const Lags& down,
                          const Lags& up) {
  const Duration common = gcd(period, parent_period);
  const Duration further_down = parent_period - common + down.most;
  const Duration further_up = period - common + up.most;
  return {above.age + further_down + further_up, above.down + further_down, above.up + further_up};
}

}  // namespace finemote::gen::timing
