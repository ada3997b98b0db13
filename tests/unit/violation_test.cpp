// Which figures of a run a fault takes the ground from.
#include "generator/run/violation.hpp"

#include "catch.hpp"
#include "unit/robot_plan.hpp"

using namespace finemote::gen;

namespace {

/// A chain of FinsROV, held against faults of one scenario.
struct Faulty {
  explicit Faulty(const std::string& assumption, const std::string& part, const std::string& port = {})
      : violations{violation_of(assumption, part, port, *plan.robot)} {
    chain.from = plan.device("imu");
    chain.to = plan.device("thruster_1");
  }

  [[nodiscard]] std::string excuse_of(Measured MeasuredChain::*figure) const {
    return violated_assumption(*plan.robot, violations, journey_of(chain, figure)).value_or("");
  }
  [[nodiscard]] std::string excuse_of_response() const {
    return violated_assumption(*plan.robot, violations, {}).value_or("");
  }

  RobotPlan plan{RobotFile{"examples/finsrov.urdf"}};
  std::vector<Violation> violations;
  MeasuredChain chain{};
};

}  // namespace

TEST_CASE("errors on a serial line excuse what comes over it, and nothing else") {
  for (const Faulty& damaged : {Faulty("bus-errors", "imu"), Faulty("bus-errors", "", "usart1")}) {
    CHECK(damaged.excuse_of(&MeasuredChain::acquire) == "bus-errors");
    CHECK(damaged.excuse_of(&MeasuredChain::end_to_end) == "bus-errors");
    CHECK(damaged.excuse_of(&MeasuredChain::decide).empty());
    CHECK(damaged.excuse_of(&MeasuredChain::wire).empty());
    CHECK(damaged.excuse_of_response().empty());
  }
  const Faulty other("bus-errors", "rov.host");
  CHECK(other.violations.front().bus);
  CHECK(other.excuse_of(&MeasuredChain::end_to_end).empty());
}

TEST_CASE("a bus may have to be recovered behind an error, which takes the time of jobs") {
  const Faulty silent("bus-errors", "baro_1");
  CHECK(silent.excuse_of(&MeasuredChain::acquire) == "bus-errors");
  CHECK(silent.excuse_of_response() == "bus-errors");
  CHECK(Faulty("recovery", "pwm").excuse_of_response() == "recovery");
}

TEST_CASE("other assumptions hold everywhere or nowhere, and each is named once") {
  const Faulty reset("bring-up", "");
  CHECK_FALSE(reset.violations.front().bus);
  CHECK(reset.excuse_of(&MeasuredChain::decide) == "bring-up");
  CHECK(Faulty("declared-nodes", "", "usart1").excuse_of_response() == "declared-nodes");
  CHECK(assumptions_of({{"bus-errors", {}}, {"bring-up", {}}, {"bus-errors", {}}}) ==
        std::vector<std::string>{"bus-errors", "bring-up"});
}
