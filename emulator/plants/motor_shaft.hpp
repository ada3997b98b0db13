// Torque to the motion of a motor's output: inertia, friction, back-EMF, end stops.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

class MotorShaft : public Shaft {
 public:
  struct Parameters {
    double inertia = 0.01;               ///< kg m^2 at the output: load, gear and rotor
    double viscous = 0.01;               ///< N m s
    double coulomb = 0;                  ///< N m
    double free_speed = 1e9;             ///< rad/s at which the supply drives no torque any more
    std::optional<double> lower, upper;  ///< rad, end stops
    double speed = 0;                    ///< rad/s at power-on
  };

  explicit MotorShaft(const Parameters& parameters) : p_(parameters), speed_(parameters.speed) {}

  double angle(Time now) override { return advance(now), angle_; }
  double speed(Time now) override { return advance(now), speed_; }
  /// What the motor gives now, after the back-EMF.
  double torque(Time now) { return advance(now), available(drive_); }

  void drive(Time now, double torque) { advance(now), drive_ = torque; }  ///< N m, from now on
  /// What else turns it: a scenario, what hangs at it, the ground under a wheel.
  enum class Load : std::uint8_t { scenario, weight, ground };
  void load(Time now, Load from, double torque) {  ///< N m, from now on
    advance(now);
    loads_[static_cast<std::size_t>(from)] = torque;
  }

 private:
  static constexpr Time kStep = from_ns(50'000);

  [[nodiscard]] double available(double torque) const {
    if (torque * speed_ <= 0) return torque;
    return torque * std::max(0.0, 1 - std::abs(speed_) / p_.free_speed);
  }

  void advance(Time now) {
    while (at_ < now) {
      const Time step = std::min(kStep, now - at_);
      move(static_cast<double>(step) / (1e9 * kStepsPerNs));
      at_ += step;
    }
  }

  void move(double dt) {
    speed_ += (available(drive_) + loads_[0] + loads_[1] + loads_[2] - p_.viscous * speed_) / p_.inertia * dt;
    const double grip = p_.coulomb / p_.inertia * dt;  // friction slows, and holds what is slow
    speed_ = std::abs(speed_) <= grip ? 0 : speed_ - std::copysign(grip, speed_);
    angle_ += speed_ * dt;
    stop_at(p_.lower, -1);
    stop_at(p_.upper, 1);
  }
  void stop_at(const std::optional<double>& end, double side) {
    if (!end || (angle_ - *end) * side <= 0) return;
    angle_ = *end;
    speed_ = 0;
  }

  Parameters p_;
  double angle_ = 0, speed_, drive_ = 0;
  std::array<double, 3> loads_{};
  Time at_ = 0;
};

}  // namespace finemote::emulator
