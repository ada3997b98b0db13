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

/// The release interrupt, then update and handle of each device.
/// @param release  of the interrupt, with the way into it and back
std::vector<BenchTest> robot_tests(const std::vector<StageLimits>& devices, Duration release);

}  // namespace finemote::gen
