// Robots for tests of their timing: from a URDF to the model the analysis is given.
#pragma once

#include "catch.hpp"
#include "generator/tasks/from_robot.hpp"
#include "generator/timing/analyse.hpp"
#include "unit/robot_plan.hpp"

namespace finemote::gen::timing {

struct Robots : RobotPlan {
  timing::Model model;

  /// @param name  of a file, from the top of the project.
  explicit Robots(const std::string& name, const RobotTimingOptions& options = {})
      : RobotPlan(RobotFile{name}), model(make_timing_model(*robot, forest, schedule, diagnostics, options).value()) {}

  /// A Type C board with `inner` in its <finemote>.
  static Robots with(const std::string& inner) { return Robots(Inner{inner}); }

  /// Place in the model.
  [[nodiscard]] Rank operator[](const std::string& name) const {
    for (const Rank d : model.devices.ids()) {
      if (model.devices[d].name == name) return d;
    }
    FAIL("no device " << name);
    return {};
  }

 private:
  struct Inner {
    const std::string& text;
  };
  explicit Robots(const Inner& inner)
      : RobotPlan(inner.text), model(make_timing_model(*robot, forest, schedule, diagnostics).value()) {}
};

inline const ChainResult& chain(const Timing& timing, const std::string& from, const std::string& to) {
  for (const ChainResult& c : timing.chains) {
    if (timing.model.devices[c.from].name == from && timing.model.devices[c.to].name == to) return c;
  }
  FAIL("no chain " << from << " -> " << to);
  return timing.chains.front();
}

}  // namespace finemote::gen::timing
