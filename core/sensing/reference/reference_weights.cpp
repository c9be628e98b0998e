#include "core/sensing/reference/reference_weights.h"

#include "core/sensing/markers/local_layout.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

// With k the diagonal of the kernel and D the offsets p_i - query, the minimum is
//   w = k (lambda - D mu),  mu = (ridge^2 I + D' k D)^-1 D' k lambda,  lambda so that sum w = 1.
Eigen::VectorXd weights_with(const Eigen::MatrixXd& offsets,
                             const Eigen::VectorXd& kernel,
                             double ridge_px) {
  const Eigen::MatrixXd weighted = kernel.asDiagonal() * offsets;
  Eigen::MatrixXd normal = offsets.transpose() * weighted;
  normal.diagonal().array() += ridge_px * ridge_px;
  const Eigen::VectorXd mean = weighted.colwise().sum().transpose();
  const Eigen::VectorXd w = kernel - weighted * normal.ldlt().solve(mean);
  return w / w.sum();
}

}  // namespace

Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points,
                                     const Eigen::VectorXd& query,
                                     double ridge_px,
                                     double most) {
  const Eigen::MatrixXd offsets = points.rowwise() - query.transpose();
  const Eigen::VectorXd square = offsets.rowwise().squaredNorm();
  // Wide enough that several frames share the noise, narrow enough that the nearest leads.
  Eigen::VectorXd sorted = square;
  std::sort(sorted.begin(), sorted.end());
  const double width = ridge_px * ridge_px + 0.25 * sorted[sorted.size() / 2];
  const Eigen::VectorXd kernel = ((sorted[0] + width) / (square.array() + width)).square().matrix();
  Eigen::VectorXd w = weights_with(offsets, kernel, ridge_px);
  double ridge = ridge_px;
  while (!w.allFinite() || w.lpNorm<1>() > most) {
    ridge *= 2;
    if (ridge > 1e6 * ridge_px) return kernel / kernel.sum();
    w = weights_with(offsets, kernel, ridge);
  }
  return w;
}

PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes,
                               const Eigen::VectorXd& place,
                               int marker_count,
                               const std::vector<char>& without,
                               int count) {
  constexpr double kMismatchPx = 0.2;  // of every marker, that is worth no more noise to avoid
  constexpr double kMostWeight = 2.9;  // sum of |w|: noise and model error grow with it
  PoseNeighbours found;
  found.rows = nearest_rows(modes, place, count, without);
  found.points.resize(static_cast<Eigen::Index>(found.rows.size()), place.size());
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    found.points.row(static_cast<Eigen::Index>(i)) = modes.row(found.rows[i]);
  const double ridge_px = kMismatchPx * std::sqrt(static_cast<double>(marker_count));
  found.weights = local_linear_weights(found.points, place, ridge_px, kMostWeight);
  return found;
}

}  // namespace alltact
