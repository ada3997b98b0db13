// What is known of a robot's execution times to the measurements of them.
#pragma once

#include <string>
#include <vector>

#include "generator/bench_kit/bench_test.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A device in the order of execution, and what its stages take at most.
struct StageLimits {
  std::string device;
  Duration update, handle;
  Ground ground = Ground::assumed;
};

/// A bus with interrupts.
struct RoutineLimit {
  std::string bus;
  Duration most;  ///< that one run of any of its routines takes, without the way into it and back
  Ground ground = Ground::assumed;
  std::string needs;  ///< to have interrupts, on a bare board; empty: nothing
};

/// The release interrupt, then the routines of each bus, then update and handle of each device.
/// @param release  of the interrupt, with the way into it and back
std::vector<BenchTest> robot_tests(const std::vector<StageLimits>& devices, const std::vector<RoutineLimit>& buses,
                                   Duration release);

}  // namespace finemote::gen
