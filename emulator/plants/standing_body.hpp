// A body that a scenario holds and turns by hand: at rest until it is moved.
#pragma once

#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

class StandingBody : public Body {
 public:
  Motion motion(Time now) override {
    advance(now);
    return motion_;
  }

  /// Puts it there, at rest.
  void place(Time now, const Angles& angles) {
    advance(now);
    motion_.attitude = attitude_of(angles);
    motion_.rate.setZero();
    feel();
  }
  /// Turns from now on, about its own axes.
  void turn(Time now, const Eigen::Vector3d& rate) {
    advance(now);
    motion_.rate = rate;
  }
  /// Accelerates from now on, in the world's axes, without leaving its place.
  void push(Time now, const Eigen::Vector3d& acceleration) {
    advance(now);
    push_ = acceleration;
    feel();
  }

 private:
  void advance(Time now) {
    if (now <= at_) return;
    const double seconds = static_cast<double>(to_ns(now - at_)) * 1e-9;
    at_ = now;
    if (motion_.rate.isZero()) return;
    motion_.attitude =
        (motion_.attitude * Eigen::AngleAxisd(motion_.rate.norm() * seconds, motion_.rate.normalized())).normalized();
    feel();
  }
  void feel() { motion_.force = motion_.attitude.conjugate() * (push_ + Eigen::Vector3d(0, 0, kGravity)); }

  Motion motion_;
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
  Time at_ = 0;
};

}  // namespace finemote::emulator
