// Where a sensor sits: the motion of a body, carried over fixed and driven joints to the sensor's own frame.
#pragma once

#include <memory>
#include <vector>

#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

/// One joint on the way from the body to the sensor.
struct JointStep {
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  Angles rpy;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  Shaft* shaft = nullptr;  ///< what turns it; null: it stands at zero
};

/// Attitude, rate and place are exact; of the specific force, what the joints' own motion adds is left out.
class Mount : public Body {
 public:
  Mount(Body& body, std::vector<JointStep> way) : body_(body), way_(std::move(way)) {}

  Motion motion(Time now) override {
    Motion m = body_.motion(now);
    for (const JointStep& step : way_) {
      m.position += m.attitude * step.xyz;
      turn(m, attitude_of(step.rpy));
      if (step.shaft == nullptr) continue;
      turn(m, Eigen::Quaterniond(Eigen::AngleAxisd(step.shaft->angle(now), step.axis)));
      m.rate += step.axis * step.shaft->speed(now);
    }
    return m;
  }

 private:
  static void turn(Motion& m, const Eigen::Quaterniond& by) {
    m.attitude = m.attitude * by;
    m.rate = by.conjugate() * m.rate;
    m.force = by.conjugate() * m.force;
  }
  Body& body_;
  std::vector<JointStep> way_;
};

}  // namespace finemote::emulator
