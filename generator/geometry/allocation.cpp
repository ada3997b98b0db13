#include "generator/geometry/allocation.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace finemote::gen {
namespace {

/// From the middle of the actuators to the one furthest away.
double reach(const std::vector<Axis>& actuators) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Axis& actuator : actuators) middle += actuator.point / static_cast<double>(actuators.size());
  double furthest = 0;
  for (const Axis& actuator : actuators) furthest = std::max(furthest, (actuator.point - middle).norm());
  return furthest;
}

}  // namespace

Eigen::MatrixXd wrench_matrix(const std::vector<Axis>& actuators) {
  Eigen::MatrixXd wrench(6, static_cast<Eigen::Index>(actuators.size()));
  for (std::size_t n = 0; n < actuators.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(n);
    wrench.block<3, 1>(0, column) = actuators[n].direction;
    wrench.block<3, 1>(3, column) = actuators[n].point.cross(actuators[n].direction);
  }
  return wrench;
}

Eigen::MatrixXd allocation(const std::vector<Axis>& actuators) { return pseudo_inverse(wrench_matrix(actuators)); }

std::array<AxisYield, 6> axis_yields(const std::vector<Axis>& actuators) {
  const Eigen::MatrixXd wrench = wrench_matrix(actuators), inverse = pseudo_inverse(wrench);
  const Eigen::MatrixXd produced = wrench * inverse;
  const double arm = reach(actuators);
  std::array<AxisYield, 6> yields;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double hardest = inverse.rows() == 0 ? 0 : inverse.col(k).cwiseAbs().maxCoeff();
    yields[static_cast<std::size_t>(k)] = {std::clamp(produced(k, k), 0.0, 1.0), k < 3 ? hardest : hardest * arm};
  }
  return yields;
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return Eigen::MatrixXd::Zero(matrix.cols(), matrix.rows());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd inverse = svd.singularValues();
  const double smallest = 1e-9 * (inverse.size() > 0 ? inverse[0] : 0);
  for (double& value : inverse) value = value > smallest ? 1 / value : 0;
  return svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

}  // namespace finemote::gen
