#include "core/sensing/markers/local_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace alltact {

std::vector<int> nearest_rows(const Eigen::MatrixXd& points,
                              const Eigen::VectorXd& query,
                              int count,
                              const std::vector<char>& without) {
  Eigen::VectorXd square = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index k = 0; k < points.cols(); ++k)
    square.array() += (points.col(k).array() - query[k]).square();
  std::vector<int> rows(static_cast<std::size_t>(points.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  if (!without.empty())
    std::erase_if(rows, [&](int row) { return without[static_cast<std::size_t>(row)] != 0; });
  const auto selected = std::min(rows.size(), static_cast<std::size_t>(std::max(0, count)));
  const auto nearer = [&](int a, int b) {
    return square[a] < square[b] || (square[a] == square[b] && a < b);
  };
  std::partial_sort(
      rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(selected), rows.end(), nearer);
  rows.resize(selected);
  return rows;
}

LocalLayout::LocalLayout(const Eigen::MatrixXd& layouts,
                         const std::vector<int>& neighbours,
                         const Markers& markers,
                         double noise_px)
    : noise_px_(noise_px) {
  const Eigen::Index size = layouts.cols(), count = static_cast<Eigen::Index>(neighbours.size());
  deviations_.resize(size, count);
  for (Eigen::Index k = 0; k < count; ++k)
    deviations_.col(k) = layouts.row(neighbours[static_cast<std::size_t>(k)]).transpose();
  const Eigen::VectorXd mean = deviations_.rowwise().mean();
  deviations_.colwise() -= mean;

  const double noise = noise_px * noise_px;
  // Coefficients of sd 2 / sqrt(count) give the neighbours' own covariance, twice as wide.
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(count, count) * (0.25 * static_cast<double>(count));
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
  double square = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (!markers[m].seen) continue;
    const auto i = static_cast<Eigen::Index>(2 * m);
    const auto rows = deviations_.middleRows(i, 2);
    information.noalias() += rows.transpose() * rows / noise;
    const Eigen::Vector2d off = Eigen::Vector2d(markers[m].u, markers[m].v) - mean.segment<2>(i);
    pull.noalias() += rows.transpose() * off / noise;
    square += off.squaredNorm() / noise;
  }
  covariance_ = information.llt().solve(Eigen::MatrixXd::Identity(count, count));
  const Eigen::VectorXd coefficients = covariance_ * pull;
  position_ = mean + deviations_ * coefficients;
  misfit_ = std::max(0.0, square - pull.dot(coefficients));
}

double LocalLayout::sd_px(int marker) const {
  const auto rows = deviations_.middleRows(2 * marker, 2);
  const Eigen::Matrix2d spread = rows * covariance_ * rows.transpose();
  return std::sqrt(std::max({0.0, spread(0, 0), spread(1, 1)}));
}

LocalLayout::Discrepancy LocalLayout::discrepancy(int marker, const Eigen::Vector2d& seen) const {
  const auto rows = deviations_.middleRows(2 * marker, 2);
  const double noise = noise_px_ * noise_px_;
  // Leaving one observation out of a linear fit divides its residual by (1 - its leverage).
  const Eigen::Matrix2d left =
      Eigen::Matrix2d::Identity() - rows * covariance_ * rows.transpose() / noise;
  const Eigen::Vector2d residual = seen - position(marker);
  const Eigen::Vector2d left_out = left.inverse() * residual;
  return {left_out.norm(), std::sqrt(std::max(0.0, residual.dot(left_out)) / noise)};
}

Eigen::MatrixXd LocalLayout::covariance_px2(const Markers& markers) const {
  const Eigen::Index size = deviations_.rows(), count = deviations_.cols();
  std::vector<Eigen::Index> seen, hidden;  // indices of coordinates
  Eigen::VectorXd own = Eigen::VectorXd::Zero(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Marker& marker = markers[static_cast<std::size_t>(k / 2)];
    (marker.seen ? seen : hidden).push_back(k);
    if (marker.seen) own[k] = marker.sd_px * marker.sd_px;
  }
  Eigen::MatrixXd result = own.asDiagonal();
  if (hidden.empty()) return result;
  const double noise = noise_px_ * noise_px_;
  const double seen_variance = seen.empty() ? 0.0 : own.sum() / static_cast<double>(seen.size());
  const double off_mixture = std::max(0.0, noise - seen_variance);
  const Eigen::MatrixXd hidden_rows = deviations_(hidden, Eigen::all);
  const Eigen::MatrixXd gain =  // response of hidden coordinates to seen ones
      hidden_rows * covariance_ * deviations_(seen, Eigen::all).transpose() / noise;
  const Eigen::VectorXd seen_own = own(seen);
  // The ridge prior is twice as wide as the neighbours' spread.
  const Eigen::MatrixXd pulled = hidden_rows * covariance_ * (0.25 * std::sqrt(count));
  const Eigen::MatrixXd shared = gain * seen_own.asDiagonal();
  result(hidden, seen) = shared;
  result(seen, hidden) = shared.transpose();
  Eigen::MatrixXd among = shared * gain.transpose() + off_mixture * gain * gain.transpose() +
                          pulled * pulled.transpose();
  among.diagonal().array() += off_mixture;
  result(hidden, hidden) = among;
  return result;
}

}  // namespace alltact
