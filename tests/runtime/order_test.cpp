// Inline variables are constructed child first, whichever unit is linked first; linked twice, in both orders.
#include "finemote/order.hpp"
#include "catch.hpp"
#include "runtime/order/tree.hpp"

int total_in_first();
int total_in_second();

TEST_CASE("a child is constructed before its parent in both link orders") {
  const finemote::View<finemote::OrderCheck> checks(order::checks);
  CHECK(finemote::first_order_violation(checks) == checks.size());
  CHECK(order::motor.construction_number() < order::arm.construction_number());
  CHECK(order::arm.construction_number() < order::body.construction_number());
  // The parent read its child when it was constructed.
  CHECK(total_in_first() == 3);
  CHECK(total_in_second() == 5);
}

TEST_CASE("a parent constructed first, or without its child, is found") {
  const std::uint32_t none = 0, one = 1, two = 2;
  const auto check = [](const std::uint32_t& child, const std::uint32_t& parent) {
    const finemote::OrderCheck checks[] = {{child, parent, "child", "parent"}};
    return finemote::first_order_violation(checks);
  };
  CHECK(check(one, two) == 1);   // fine: no violation
  CHECK(check(two, one) == 0);   // parent first
  CHECK(check(none, one) == 0);  // child never constructed
}
