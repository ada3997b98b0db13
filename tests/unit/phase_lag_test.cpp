// Degrees by which a chain lags at a frequency, against worked examples.
#include "generator/timing/phase_lag.hpp"
#include "catch.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

Model one_device(Duration period) {
  Model model;
  Device device;
  device.period = period;
  model.devices.push_back(device);
  return model;
}

ChainResult chain_of(std::optional<Duration> end_to_end) {
  ChainResult chain{};
  chain.end_to_end = end_to_end;
  return chain;
}

}  // namespace

TEST_CASE("a delay of a quarter of the time of a sine turns it by a quarter of a turn") {
  const auto lag = phase_lag(one_device(milliseconds(10)), chain_of(milliseconds(125)), 2);
  REQUIRE(lag);
  CHECK(lag->age == Approx(90));
  CHECK(lag->hold == Approx(3.6));  // 5 ms in the mean
  CHECK(lag->total() == Approx(93.6));
}

TEST_CASE("lag grows with the frequency, below a hertz too") {
  const Model model = one_device(milliseconds(1));
  const ChainResult chain = chain_of(microseconds(36390));
  CHECK(phase_lag(model, chain, 0.5)->age == Approx(6.5502));
  CHECK(phase_lag(model, chain, 50)->age == Approx(655.02));
}

TEST_CASE("a chain without a bound has no lag") {
  CHECK_FALSE(phase_lag(one_device(milliseconds(10)), chain_of({}), 2));
}
