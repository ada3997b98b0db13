#include "generator/bench_kit/robot_tests.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// As a text of C++ and JSON that needs no escapes.
std::string plain(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '"' || c == '\\' || c == '?'; }, '_');
  return name;
}

BenchTest stage_test(const std::string& device, const char* stage, Duration limit, Ground ground) {
  return {"robot", "stage." + plain(device) + "." + stage + "_ns", 0, limit.ns(), ground, "WCET of the stage"};
}

}  // namespace

std::vector<BenchTest> robot_tests(const std::vector<StageLimits>& devices, const std::vector<RoutineLimit>& buses,
                                   Duration release) {
  std::vector<BenchTest> tests{
      {"robot", "release.cost_ns", 0, release.ns(), Ground::assumed, "release and exception costs of the board file"}};
  for (const RoutineLimit& it : buses) {
    tests.push_back({"robot", "routine." + plain(it.bus) + "_ns", 0, it.most.ns(), it.ground,
                     "longest routine of the bus, as the timing analysis charges it", it.needs});
  }
  for (const StageLimits& it : devices) {
    tests.push_back(stage_test(it.device, "update", it.update, it.ground));
    tests.push_back(stage_test(it.device, "handle", it.handle, it.ground));
  }
  return tests;
}

}  // namespace finemote::gen
