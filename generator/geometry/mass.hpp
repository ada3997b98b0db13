// Inertials of links to the mass of what moves together.
#pragma once

#include <set>

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

struct Mass {
  double mass = 0;                                    ///< [kg]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();   ///< mass times centre of mass [kg m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the frame's origin [kg m^2]

  /// [m]; the frame's origin where there is no mass.
  [[nodiscard]] Eigen::Vector3d centre() const {
    return mass > 0 ? Eigen::Vector3d(moment / mass) : Eigen::Vector3d::Zero();
  }
};

/// A link and everything behind it, in the link's frame, with every joint at zero; without what the joints named in
/// `but` carry.
Mass mass_behind(const Mechanism& mechanism, const std::string& link, const std::set<std::string>& but = {});

}  // namespace finemote::gen
