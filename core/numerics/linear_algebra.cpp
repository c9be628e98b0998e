#include "core/numerics/linear_algebra.h"

#include <algorithm>
#include <limits>

#include <Eigen/QR>

namespace alltact {

Eigen::VectorXd least_squares(const Eigen::MatrixXd& design, const Eigen::VectorXd& target) {
  return design.householderQr().solve(target);
}

Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric_eigen(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix);
}

std::vector<int> farthest_point_order(const Eigen::MatrixXd& points, int count) {
  const Eigen::Index n = points.rows();
  std::vector<int> order;
  if (n == 0) return order;
  Eigen::VectorXd distance = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  Eigen::Index taken = 0;
  while (static_cast<int>(order.size()) < std::min<Eigen::Index>(count, n)) {
    order.push_back(static_cast<int>(taken));
    const Eigen::VectorXd to_taken =
        (points.rowwise() - points.row(taken).eval()).rowwise().squaredNorm();
    distance = distance.cwiseMin(to_taken);
    distance[taken] = -1;  // never again, also among equal points
    distance.maxCoeff(&taken);
  }
  return order;
}

}  // namespace alltact
