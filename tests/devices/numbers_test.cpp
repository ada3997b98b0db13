// Angles, time steps, and values that are none.
#include "finemote/control/numbers.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "finemote/control/step_time.hpp"

using namespace finemote;

TEST_CASE("angles wrap to half a turn") {
  CHECK(wrap_angle(3.5F) == Approx(3.5 - 6.2831853).epsilon(1e-5));
  CHECK(wrap_angle(-3.5F) == Approx(6.2831853 - 3.5).epsilon(1e-5));
  CHECK(wrap_angle(100.0F) == Approx(100 - 16 * 6.2831853).margin(1e-4));
  CHECK(std::fabs(wrap_angle(9e5F)) <= 3.1416F);
  CHECK(wrap_angle(1e30F) == 0);
  CHECK(wrap_angle(std::numeric_limits<float>::infinity()) == 0);
}

TEST_CASE("a time step in seconds stays within two of them") {
  CHECK(seconds(5 * kMillisecond) == Approx(0.005));
  CHECK(seconds(-1) == 0);
  CHECK(seconds(60 * kSecond) == 2);
}

TEST_CASE("a control law steps over the time since its last step, and over no gap") {
  StepTime step;
  CHECK(step.next(10 * kSecond) == 0);  // the first one
  CHECK(step.next(10 * kSecond + 5 * kMillisecond) == Approx(0.005));
  CHECK(step.next(10 * kSecond + 104 * kMillisecond) == Approx(0.099));
  CHECK(step.next(10 * kSecond + 205 * kMillisecond) == 0);
  CHECK(step.next(10 * kSecond + 206 * kMillisecond) == Approx(0.001));
}
