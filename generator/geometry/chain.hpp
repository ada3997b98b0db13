// Joints in a row to what each carries.
#pragma once

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// A joint of a serial chain and what moves with it but not with the next; axes of a link, all joints at zero.
struct ChainLink {
  Eigen::Vector3d offset;  ///< from the joint before, the first: from the link's origin [m]
  Eigen::Vector3d axis;    ///< unit length
  Eigen::Vector3d centre;  ///< of the mass, from the joint [m]
  double mass = 0;         ///< [kg]
};

/// Why joint `index`, which turns, cannot follow the one before it in a chain; empty: it can.
std::string chain_problem(const Mechanism& mechanism, const std::vector<std::string>& joints, std::size_t index);

/// @param joints  base to tip, each without chain_problem()
/// @param link    whose axes and origin
std::vector<ChainLink> chain(const Mechanism& mechanism, const std::vector<std::string>& joints,
                             const std::string& link);

}  // namespace finemote::gen
