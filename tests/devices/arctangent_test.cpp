// Arc tangent and arc sine against the C library's in double, over all quadrants, sizes and the seams between ranges.
#include "finemote/control/arctangent.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace finemote;

namespace {

constexpr double kMost = 5e-7;  ///< what the header promises
constexpr float kTurn = 6.28318531F;

double error_at(float y, float x) { return std::fabs(arctangent(y, x) - std::atan2(double{y}, double{x})); }

}  // namespace

TEST_CASE("an arc tangent is what the library says all around") {
  double worst = 0;
  constexpr int kPlaces = 200'000;
  for (const float size : {1e-30F, 0.001F, 1.0F, 9.81F, 1e30F}) {
    for (int i = 0; i < kPlaces; ++i) {
      const float angle = (static_cast<float>(i) + 0.37F) * (kTurn / kPlaces);
      worst = std::fmax(worst, error_at(size * std::sin(angle), size * std::cos(angle)));
    }
  }
  CHECK(worst <= kMost);
  CHECK(worst > 1e-8);  // it is compared with something else than itself
}

TEST_CASE("an arc tangent has no step where its ranges meet") {
  for (const float tangent : {0.41421356F, 1.0F, 2.41421356F}) {
    float y = tangent;
    for (int i = 0; i < 64; ++i) y = std::nextafter(y, 0.0F);
    for (int i = 0; i < 128; ++i) {
      CHECK(error_at(y, 1) <= kMost);
      CHECK(error_at(-y, -1) <= kMost);
      y = std::nextafter(y, 9.0F);
    }
  }
}

TEST_CASE("an arc tangent on the axes") {
  CHECK(arctangent(0, 0) == 0);
  CHECK(arctangent(0, 3) == 0);
  CHECK(arctangent(3, 0) == Approx(1.57079633).margin(kMost));
  CHECK(arctangent(-3, 0) == Approx(-1.57079633).margin(kMost));
  CHECK(arctangent(0, -3) == Approx(3.14159265).margin(kMost));
  CHECK(std::isnan(arctangent(std::numeric_limits<float>::quiet_NaN(), 1)));
  CHECK(std::isnan(arctangent(1, std::numeric_limits<float>::quiet_NaN())));
}

TEST_CASE("an arc sine is what the library says, and stays in its range beyond") {
  double worst = 0;
  for (int i = -100'000; i <= 100'000; ++i) {
    const float sine = static_cast<float>(i) * 1e-5F;
    worst = std::fmax(worst, std::fabs(arcsine(sine) - std::asin(double{sine})));
  }
  CHECK(worst <= kMost);
  CHECK(arcsine(1.5F) == Approx(1.57079633).margin(kMost));
  CHECK(arcsine(-1.5F) == Approx(-1.57079633).margin(kMost));
}
