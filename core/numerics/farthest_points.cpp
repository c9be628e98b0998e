#include "core/numerics/farthest_points.h"

#include <algorithm>
#include <limits>

namespace alltact {

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
