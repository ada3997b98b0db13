// The measurements of one kit, and the header that tells its image of them.
#pragma once

#include <string>
#include <vector>

#include "generator/bench_kit/bench_test.hpp"
#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// An interrupt line of a bus of the robot.
struct BusLine {
  std::uint32_t line = 0;
  std::size_t bus = 0;  ///< of those with interrupts, in their order
};

struct BenchPlan {
  const Board& board;
  std::string robot;  ///< the kit measures its stages
  std::vector<BenchTest> tests;
  std::uint32_t free_line = 0;  ///< an interrupt line that no bucket of the robot runs in
  std::size_t stages = 0;       ///< how many of the tests, the last ones: update and handle of each device in its order
  std::size_t buses = 0;        ///< how many before those: the routines of each bus
  std::vector<BusLine> bus_lines = {};

  /// Of names and expectations: two kits with the same answer to the same. 16 hexadecimal digits.
  [[nodiscard]] std::string identity() const;
};

/// Groups in the order in which the tests name them first.
std::vector<std::string> bench_groups(const std::vector<BenchTest>& tests);

/// bench_plan.hpp: tests, groups, and the pins of the ports that are measured.
std::string bench_plan_header(const BenchPlan& plan);

}  // namespace finemote::gen
