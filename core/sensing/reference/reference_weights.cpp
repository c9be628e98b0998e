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

/// Of rows by their distance from the pose, the nearest half, and beyond them those that stand for
/// a side of it each: one that lies nearer to a row taken before than half its way to the pose
/// tells nearly the same as that.
std::vector<int> on_all_sides(const Eigen::MatrixXd& modes,
                              const Eigen::VectorXd& place,
                              const std::vector<int>& nearest,
                              int count) {
  constexpr double kApart = 0.5;
  const auto most = static_cast<std::size_t>(count);
  std::vector<int> taken, passed;
  for (const int row : nearest) {
    if (taken.size() == most) break;
    const double least_px = kApart * (modes.row(row) - place.transpose()).norm();
    const bool is_another =
        taken.size() < (most + 1) / 2 || std::all_of(taken.begin(), taken.end(), [&](int other) {
          return (modes.row(row) - modes.row(other)).norm() >= least_px;
        });
    (is_another ? taken : passed).push_back(row);
  }
  for (std::size_t i = 0; taken.size() < most && i < passed.size(); ++i) taken.push_back(passed[i]);
  return taken;
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
  constexpr int kLookedAt = 8;  // times as many
  found.rows =
      on_all_sides(modes, place, nearest_rows(modes, place, kLookedAt * count, without), count);
  found.points.resize(static_cast<Eigen::Index>(found.rows.size()), place.size());
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    found.points.row(static_cast<Eigen::Index>(i)) = modes.row(found.rows[i]);
  const double ridge_px = kMismatchPx * std::sqrt(static_cast<double>(marker_count));
  found.weights = local_linear_weights(found.points, place, ridge_px, kMostWeight);
  return found;
}

}  // namespace alltact
