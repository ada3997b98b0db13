// What several runs of one image leave behind together.
#include "catch.hpp"
#include "generator/run/record.hpp"

using namespace finemote::gen;

TEST_CASE("a part that one of the runs never saw is absent, and errors of a bus count from whichever run") {
  RunRecord first, second;
  first.absent = {"imu"};
  second.absent = {"imu", "depth"};
  first.buses = {{BusId{0}, 10, 1}, {BusId{1}, 10, 0}};
  second.buses = {{BusId{0}, 10, 0}, {BusId{1}, 10, 3}};
  merge(first, second);
  CHECK(first.absent == std::vector<std::string>{"imu", "depth"});
  CHECK(first.buses[0].errors == 1);
  CHECK(first.buses[1].errors == 3);
}

TEST_CASE("faults of all runs are counted together") {
  RunRecord first, second;
  first.late_faults = {{5, 1, 1}};
  second.late_faults = {{5, 1, 2}, {5, 2, 1}};
  merge(first, second);
  REQUIRE(first.late_faults.size() == 2);
  CHECK(first.late_faults[0].count == 3);
}
