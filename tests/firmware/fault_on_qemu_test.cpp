// What goes wrong on the processor is noticed, named, and ends the run: stack guard, stray interrupts, faults, overrun.
#include "catch.hpp"
#include "firmware/qemu.hpp"

using finemote::test::run_on_qemu;

TEST_CASE("a stack overflow runs into the guard") {
  const auto run = run_on_qemu("faulty_stack");
  CHECK(run.status == 1);
  CHECK(run.text.rfind("core: stack overflow\n", 0) == 0);
}

TEST_CASE("an interrupt line without a routine is a fault of its own") {
  const auto run = run_on_qemu("faulty_line");
  CHECK(run.status == 1);
  CHECK(run.text.rfind("core: interrupt line without a routine\n", 0) == 0);
}

TEST_CASE("an undefined instruction and a bus error are told apart") {
  CHECK(run_on_qemu("faulty_usage").text.rfind("core: usage fault\n", 0) == 0);
  CHECK(run_on_qemu("faulty_bus").text.rfind("core: bus fault\n", 0) == 0);
}

TEST_CASE("an overrun stops the robot when the schedule says so, and is counted") {
  const auto run = run_on_qemu("faulty_overrun");
  CHECK(run.status == 1);
  const std::string counted = "schedule: a bucket overran\nO 0 1\nF 2 7 2\nS ";
  REQUIRE(run.text.rfind(counted, 0) == 0);
  const long long stopped_ns = std::stoll(run.text.substr(counted.size()));
  CHECK(stopped_ns >= 20'000'000);  // found at the release of 20 ms
  CHECK(stopped_ns < 21'000'000);
}
