#include "generator/timing/hand_over.hpp"

#include <algorithm>

namespace finemote::gen::timing {

ClosedForm closed_form_of(const HandOver& exact, Ns period, Ns root_period) {
  ClosedForm closed;
  closed.age = std::max<Ns>(0, add(oldest_age(join(*exact.down, *exact.up, exact.length)), -period));
  for (const Staircase::Step& step : exact.down->steps) {
    closed.down = std::max(closed.down, step.device - period - step.root * root_period);
  }
  for (const Staircase::Step& step : exact.up->steps) {
    closed.up = std::max(closed.up, step.root * root_period - step.device);
  }
  return closed;
}

ClosedForm one_edge_below(const ClosedForm& above, Ns parent_period, Ns period, const Lags& down, const Lags& up) {
  const Ns common = std::gcd(period, parent_period);
  const Ns further_down = add(parent_period - common, down.most);
  const Ns further_up = add(period - common, up.most);
  return {add(above.age, add(further_down, further_up)), add(above.down, further_down), add(above.up, further_up)};
}

}  // namespace finemote::gen::timing
