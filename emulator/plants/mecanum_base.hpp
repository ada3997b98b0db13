// The turning of mecanum wheels to the motion of the base they carry, over rollers that grip the ground.
#pragma once

#include <vector>

#include "emulator/plants/motor_shaft.hpp"

namespace finemote::emulator {

/// Stands on level ground: moves in the plane and turns about z. Each wheel's contact pushes along the axis of its
/// rollers, against sliding, and no harder than friction lets it; across, the rollers turn freely.
class MecanumBase : public Body {
 public:
  struct Parameters {
    double mass = 15;       ///< kg
    double inertia = 0.5;   ///< kg m^2 about z
    double grip = 600;      ///< N s/m: force of a contact per speed of sliding
    double friction = 0.7;  ///< largest force of a contact, as share of its share of the weight
    double drag = 4;        ///< N s/m against moving; about z the same at an arm of 0.3 m
  };
  struct Wheel {
    MotorShaft* shaft;
    double radius;           ///< m
    Eigen::Vector2d place;   ///< of the contact, in the base's axes [m]
    Eigen::Vector2d way;     ///< the contact of a wheel that turns positive goes back along it; unit length
    Eigen::Vector2d roller;  ///< axis of the roller at the ground, unit length
  };
  static constexpr Time kStep = from_ns(250'000);

  explicit MecanumBase(const Parameters& parameters) : p_(parameters) {}

  void add_wheel(const Wheel& wheel) { wheels_.push_back(wheel); }
  /// Finds the forces until the next step. To be called every kStep.
  void step(Time now);
  Motion motion(Time now) override;
  /// A force in the world's axes and a moment about z, from now on: a push, a collision.
  void disturb(Time now, const Eigen::Vector3d& force, double moment);

 private:
  void advance(Time now);

  Parameters p_;
  std::vector<Wheel> wheels_;
  double yaw_ = 0, turn_ = 0, turn_up_ = 0;  ///< rad, rad/s, rad/s^2
  Eigen::Vector2d position_ = Eigen::Vector2d::Zero(), velocity_ = Eigen::Vector2d::Zero(),
                  push_ = Eigen::Vector2d::Zero();  ///< in the world's axes; the last: acceleration
  Eigen::Vector2d pull_ = Eigen::Vector2d::Zero();
  double twist_ = 0;
  Time at_ = 0;
};

}  // namespace finemote::emulator
