// sim_load and group: the oldest goes up, the command goes down.
#include "finemote/devices/group.hpp"
#include "finemote/devices/sim_load.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

using namespace finemote;

TEST_CASE("a load works for its time and stamps when it began") {
  bench::reset();
  SimLoad load{{30 * kMicrosecond, 20 * kMicrosecond}};
  Time began = 0, updated = 0, handled = 0;
  bench::robot().slow = [&] {
    began = now();
    load.update();
    updated = now();
    load.handle();
    handled = now();
  };
  bench::run(5 * kMillisecond);
  CHECK(updated - began == 30 * kMicrosecond);
  CHECK(handled - updated == 20 * kMicrosecond);
  CHECK(load.state.origin == began);
  CHECK(load.state.valid);
}

TEST_CASE("inner devices pass the oldest origin up and their command down") {
  Stamp a{100, true}, b{50, true}, command_a, command_b;
  const Port<Any> children[] = {{a, command_a}, {b, command_b}};
  SimLoad load{{0, 0}, children};
  Group group{children};

  load.update();
  group.update();
  CHECK(load.state.origin == 50);
  CHECK(group.state.origin == 50);
  CHECK(group.state.valid);

  group.handle();  // a root: its own freshness
  CHECK(command_a.origin == 50);
  CHECK(command_a.valid);
  load.command = {77, true};
  load.handle();
  CHECK(command_a.origin == 77);
  CHECK(command_b.origin == 77);

  a.valid = false;
  load.update();
  group.update();
  CHECK_FALSE(load.state.valid);
  CHECK_FALSE(group.state.valid);
}
