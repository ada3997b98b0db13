// Thrusts to the motion of a vehicle under water: rigid body, added mass, drag, buoyancy above the centre of mass.
#pragma once

#include <vector>

#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

/// Floats at the surface (world z = 0) until it is pushed under. Coefficients as T. Fossen, Handbook of Marine Craft
/// Hydrodynamics and Motion Control, chapter 6, all of them diagonal.
class SubmergedBody : public Body {
 public:
  struct Parameters {
    double mass = 5;                                              ///< kg
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity() * 0.1;  ///< kg m^2
    double added_mass = 0.5;                                      ///< share of mass and inertia that moves along
    double linear_drag = 4;     ///< N s/m per kg of mass, per direction; the same share of inertia about the axes
    double quadratic_drag = 6;  ///< N s^2/m^2 per kg of mass
    double buoyancy = 0.01;     ///< net lift when submerged, as share of the weight
    double righting = 0.01;     ///< m, centre of buoyancy above the centre of mass
    double height = 0.2;        ///< m from just afloat to wholly submerged
  };

  explicit SubmergedBody(const Parameters& parameters) : p_(parameters) {}

  Motion motion(Time now) override;
  [[nodiscard]] double depth(Time now) { return -motion(now).position.z(); }  ///< m, of the origin below the surface

  /// A thruster at `point` that pushes along `direction`, both in the body's axes. @return its number
  std::size_t add_thruster(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, double lag_seconds);
  void thrust(Time now, std::size_t thruster, double newton);
  /// A force in the world's axes and a moment in the body's, from now on: a current, a tug at the tether.
  void disturb(Time now, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);

 private:
  struct Thruster {
    Eigen::Vector3d point, direction;
    double lag = 0, wanted = 0, force = 0;
  };
  static constexpr Time kStep = from_ns(500'000);
  void advance(Time now);
  void move(double dt);
  [[nodiscard]] double submerged() const;

  Parameters p_;
  std::vector<Thruster> thrusters_;
  Motion motion_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  // in the world's axes
  Eigen::Vector3d pull_ = Eigen::Vector3d::Zero(), twist_ = Eigen::Vector3d::Zero();
  Time at_ = 0;
};

}  // namespace finemote::emulator
