// The type on the bench: wires of all ports in virtual time (finemote/bench/bench.hpp).
#include "@name@.hpp"

#include "finemote/bench/bench.hpp"
#include "finemote/bench/checks.hpp"

using namespace finemote;

int main() {
  bench::Checks checks;
  bench::reset();
  @name@::@class@ device({2.0F});
  bench::robot().slow = [&] { device.update(); };

  checks.that(bench::run(25 * kMillisecond), "the robot of the bench runs");
  checks.that(device.state.valid, "there is a value");
  checks.near(device.state.value, 2, 1e-6, "the value");
  checks.equal(device.state.origin, 20 * kMillisecond, "its age");
  return checks.status();
}
