#include "finemote/order.hpp"

namespace finemote {

std::size_t first_order_violation(View<OrderCheck> checks) {
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const OrderCheck& check = checks[i];
    if (check.child == 0 || check.child > check.parent) return i;
  }
  return checks.size();
}

}  // namespace finemote
