#include "emulator/plants/mecanum_base.hpp"

namespace finemote::emulator {
namespace {

constexpr double kArmOfDrag = 0.3;  // m

}  // namespace

void MecanumBase::step(Time now) {
  advance(now);
  const Eigen::Rotation2Dd to_world(yaw_);
  const Eigen::Vector2d velocity = to_world.inverse() * velocity_;
  const double most = p_.friction * p_.mass * kGravity / static_cast<double>(wheels_.size());
  Eigen::Vector2d force = -p_.drag * velocity;
  double moment = twist_ - p_.drag * kArmOfDrag * kArmOfDrag * turn_;
  for (const Wheel& wheel : wheels_) {
    const Eigen::Vector2d contact = velocity + turn_ * Eigen::Vector2d(-wheel.place.y(), wheel.place.x());
    const double rolled = wheel.shaft->speed(now) * wheel.radius;
    const double sliding = wheel.roller.dot(contact - rolled * wheel.way);
    const double grip = std::clamp(-p_.grip * sliding, -most, most);
    force += grip * wheel.roller;
    moment += grip * (wheel.place.x() * wheel.roller.y() - wheel.place.y() * wheel.roller.x());
    wheel.shaft->load(now, MotorShaft::Load::ground, -grip * wheel.radius * wheel.roller.dot(wheel.way));
  }
  push_ = (to_world * force + pull_) / p_.mass;
  turn_up_ = moment / p_.inertia;
}

void MecanumBase::disturb(Time now, const Eigen::Vector3d& force, double moment) {
  advance(now);
  pull_ = force.head<2>();
  twist_ = moment;
}

void MecanumBase::advance(Time now) {
  if (now <= at_) return;  // sensors ask for when they sampled
  const double dt = static_cast<double>(now - at_) / (1e9 * kStepsPerNs);
  at_ = now;
  position_ += (velocity_ + push_ * dt / 2) * dt;
  velocity_ += push_ * dt;
  yaw_ += (turn_ + turn_up_ * dt / 2) * dt;
  turn_ += turn_up_ * dt;
}

Motion MecanumBase::motion(Time now) {
  advance(now);
  Motion motion;
  motion.attitude = attitude_of(Angles{0, 0, yaw_});
  motion.position.head<2>() = position_;
  motion.rate = Eigen::Vector3d(0, 0, turn_);
  motion.force = motion.attitude.conjugate() * Eigen::Vector3d(push_.x(), push_.y(), kGravity);
  return motion;
}

}  // namespace finemote::emulator
