// A board file to the measurements that a bare board can make of itself, and what it should find.
#pragma once

#include <vector>

#include "generator/bench_kit/bench_test.hpp"
#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// In the order they run.
/// @param board  of an STM32F4, with clocks
std::vector<BenchTest> board_tests(const Board& board);

}  // namespace finemote::gen
