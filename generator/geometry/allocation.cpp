#include "generator/geometry/allocation.hpp"

#include <Eigen/SVD>

namespace finemote::gen {

Eigen::MatrixXd allocation(const std::vector<Axis>& actuators) {
  Eigen::MatrixXd wrench(6, static_cast<Eigen::Index>(actuators.size()));
  for (std::size_t n = 0; n < actuators.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(n);
    wrench.block<3, 1>(0, column) = actuators[n].direction;
    wrench.block<3, 1>(3, column) = actuators[n].point.cross(actuators[n].direction);
  }
  return pseudo_inverse(wrench);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd inverse = svd.singularValues();
  const double smallest = 1e-9 * (inverse.size() > 0 ? inverse[0] : 0);
  for (double& value : inverse) value = value > smallest ? 1 / value : 0;
  return svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
}

}  // namespace finemote::gen
