// PID: limits, anti-windup, independence of the step, and values that are none.
#include "finemote/control/pid.hpp"

#include <limits>

#include "catch.hpp"

using namespace finemote;

TEST_CASE("terms add up in real units") {
  Pid pid;
  CHECK(pid.step({2, 0, 0, 100}, 3, 0, 0.01F) == Approx(6));
  CHECK(pid.step({2, 0, 0.5F, 100}, 3, 4, 0.01F) == Approx(4));
  Pid integrating;
  for (int i = 0; i < 100; ++i) integrating.step({0, 2, 0, 100}, 3, 0, 0.01F);
  CHECK(integrating.integral() == Approx(6).epsilon(0.001));  // 2 * 3 * 1 s
}

TEST_CASE("the integral over a second is the same at every rate") {
  Pid fast, slow;
  for (int i = 0; i < 1000; ++i) fast.step({1, 1, 0, 100}, 5, 0, 0.001F);
  for (int i = 0; i < 50; ++i) slow.step({1, 1, 0, 100}, 5, 0, 0.02F);
  CHECK(fast.integral() == Approx(slow.integral()).epsilon(0.001));
}

TEST_CASE("a saturated output does not wind up") {
  Pid pid;
  for (int i = 0; i < 10000; ++i) CHECK(pid.step({1, 1, 0, 2}, 50, 0, 0.01F) <= 2);
  CHECK(pid.integral() <= 2);
  CHECK(pid.step({1, 1, 0, 2}, -0.5F, 0, 0.01F) < 2);  // back at once
  CHECK(pid.step({1, 1, 0, 2}, -50, 0, 0.01F) == -2);
}

TEST_CASE("zero gains and zero time are no trouble") {
  Pid pid;
  CHECK(pid.step({0, 0, 0, 1}, 5, 5, 0) == 0);
  CHECK(pid.step({1, 1, 1, 1}, 0, 0, 0) == 0);
}

TEST_CASE("errors that are no numbers give 0 and change nothing") {
  Pid pid;
  pid.step({1, 1, 0, 10}, 1, 0, 0.01F);
  const float before = pid.integral();
  CHECK(pid.step({1, 1, 0, 10}, std::numeric_limits<float>::quiet_NaN(), 0, 0.01F) == 0);
  CHECK(pid.step({1, 1, 0, 10}, std::numeric_limits<float>::infinity(), 0, 0.01F) == 0);
  CHECK(pid.integral() == before);
}
