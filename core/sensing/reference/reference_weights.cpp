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

/// Selects rows by their distance from the pose: the nearest half, and further ones in new
/// directions. A row is redundant if it lies nearer to a selected row than half of its distance to
/// the pose.
std::vector<int> spread_neighbours(const Eigen::MatrixXd& modes,
                                   const Eigen::VectorXd& pose,
                                   const std::vector<int>& nearest,
                                   int count) {
  constexpr double kApart = 0.5;
  const auto max_rows = static_cast<std::size_t>(count);
  std::vector<int> taken, passed;
  for (const int row : nearest) {
    if (taken.size() == max_rows) break;
    const double min_px = kApart * (modes.row(row) - pose.transpose()).norm();
    const bool is_another = taken.size() < (max_rows + 1) / 2 ||
                            std::all_of(taken.begin(), taken.end(), [&](int other) {
                              return (modes.row(row) - modes.row(other)).norm() >= min_px;
                            });
    (is_another ? taken : passed).push_back(row);
  }
  for (std::size_t i = 0; taken.size() < max_rows && i < passed.size(); ++i)
    taken.push_back(passed[i]);
  return taken;
}

}  // namespace

Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points,
                                     const Eigen::VectorXd& query,
                                     double ridge_px,
                                     double max_magnitude) {
  const Eigen::MatrixXd offsets = points.rowwise() - query.transpose();
  const Eigen::VectorXd square = offsets.rowwise().squaredNorm();
  // Wide enough that several frames share the noise, narrow enough that the nearest one dominates.
  Eigen::VectorXd sorted = square;
  std::sort(sorted.begin(), sorted.end());
  const double width = ridge_px * ridge_px + 0.25 * sorted[sorted.size() / 2];
  const Eigen::VectorXd kernel = ((sorted[0] + width) / (square.array() + width)).square().matrix();
  Eigen::VectorXd w = weights_with(offsets, kernel, ridge_px);
  double ridge = ridge_px;
  while (!w.allFinite() || w.lpNorm<1>() > max_magnitude) {
    ridge *= 2;
    if (ridge > 1e6 * ridge_px) return kernel / kernel.sum();
    w = weights_with(offsets, kernel, ridge);
  }
  return w;
}

PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes,
                               const Eigen::VectorXd& pose,
                               int marker_count,
                               const std::vector<char>& without,
                               int count) {
  // of every marker: a smaller mismatch is not worth more noise
  constexpr double kMismatchPx = 0.2;
  constexpr double kMaxWeight = 2.9;  // sum of |w|: noise and model error grow with it
  PoseNeighbours found;
  constexpr int kCandidates = 8;  // times as many
  found.rows = spread_neighbours(
      modes, pose, nearest_rows(modes, pose, kCandidates * count, without), count);
  found.points.resize(static_cast<Eigen::Index>(found.rows.size()), pose.size());
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    found.points.row(static_cast<Eigen::Index>(i)) = modes.row(found.rows[i]);
  const double ridge_px = kMismatchPx * std::sqrt(static_cast<double>(marker_count));
  found.weights = local_linear_weights(found.points, pose, ridge_px, kMaxWeight);
  return found;
}

}  // namespace alltact
