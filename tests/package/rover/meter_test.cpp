// The rover's own type on the bench.
#include "meter.hpp"

#include "finemote/bench/bench.hpp"
#include "finemote/bench/checks.hpp"
#include "finemote/bench/parts.hpp"

int main() {
  finemote::bench::Checks checks;
  finemote::bench::reset();
  rover::Meter alone{{}};
  finemote::bench::robot().fast = [&] { alone.update(); };
  checks.that(finemote::bench::run(20 * finemote::kMillisecond), "the robot of the bench runs");
  checks.equal(alone.jobs(), 0U, "jobs without wheels");
  checks.near(0.1 + 0.2, 0.3, 1e-12, "sums");
  return checks.status();
}
