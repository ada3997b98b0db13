#include "emulator/plants/submerged_body.hpp"

#include <algorithm>

namespace finemote::emulator {

std::size_t SubmergedBody::add_thruster(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                                        double lag_seconds) {
  thrusters_.push_back(Thruster{point, direction, lag_seconds});
  return thrusters_.size() - 1;
}

void SubmergedBody::thrust(Time now, std::size_t thruster, double newton) {
  advance(now);
  thrusters_[thruster].wanted = newton;
}

void SubmergedBody::disturb(Time now, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
  advance(now);
  pull_ = force;
  twist_ = moment;
}

Motion SubmergedBody::motion(Time now) {
  advance(now);
  return motion_;
}

void SubmergedBody::advance(Time now) {
  while (at_ < now) {
    const Time step = std::min(kStep, now - at_);
    move(static_cast<double>(step) / (1e9 * kStepsPerNs));
    at_ += step;
  }
}

/// Share of the hull under water: it floats with nearly all of it.
double SubmergedBody::submerged() const {
  return std::clamp(1 / (1 + p_.buoyancy) - motion_.position.z() / p_.height, 0.0, 1.0);
}

void SubmergedBody::move(double dt) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = twist_;
  for (Thruster& thruster : thrusters_) {
    thruster.force += (thruster.wanted - thruster.force) * dt / (thruster.lag + dt);
    const Eigen::Vector3d push = thruster.direction * thruster.force;
    force += push;
    moment += thruster.point.cross(push);
  }
  const double lift = p_.mass * kGravity * (1 + p_.buoyancy) * submerged();
  const Eigen::Vector3d up = motion_.attitude.conjugate() * Eigen::Vector3d::UnitZ();
  moment += Eigen::Vector3d(0, 0, p_.righting).cross(up * lift);

  const Eigen::Vector3d along = motion_.attitude.conjugate() * velocity_;
  const auto drag = [this](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(v.array() * (p_.linear_drag + p_.quadratic_drag * v.array().abs()));
  };
  force -= p_.mass * drag(along);
  moment -= p_.inertia * drag(motion_.rate);

  const Eigen::Vector3d weight(0, 0, lift - p_.mass * kGravity);
  const Eigen::Vector3d acceleration = (motion_.attitude * force + weight + pull_) / (p_.mass * (1 + p_.added_mass));
  const Eigen::Matrix3d inertia = p_.inertia * (1 + p_.added_mass);
  motion_.rate += inertia.inverse() * (moment - motion_.rate.cross(inertia * motion_.rate)) * dt;
  velocity_ += acceleration * dt;
  motion_.position += velocity_ * dt;
  const double turned = motion_.rate.norm() * dt;
  if (turned > 0)
    motion_.attitude = (motion_.attitude * Eigen::AngleAxisd(turned, motion_.rate.normalized())).normalized();
  motion_.force = motion_.attitude.conjugate() * (acceleration + Eigen::Vector3d(0, 0, kGravity));
}

}  // namespace finemote::emulator
