#include "core/sensing/markers/layout_gaps.h"

#include "core/numerics/symmetric_eigen.h"
#include "core/sensing/markers/local_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kMaxGapModes = 6;
constexpr int kPasses = 12;
constexpr int kLocalPasses = 4;
constexpr std::size_t kEnoughRows = 40;
constexpr double kNoisePx = 0.1;

std::vector<Eigen::Index> seen_coordinates(const Eigen::MatrixXd& layouts, Eigen::Index row) {
  std::vector<Eigen::Index> seen;
  for (Eigen::Index k = 0; k < layouts.cols(); ++k)
    if (std::isfinite(layouts(row, k))) seen.push_back(k);
  return seen;
}

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& layouts, const std::vector<Eigen::Index>& rows) {
  Eigen::MatrixXd selected(static_cast<Eigen::Index>(rows.size()), layouts.cols());
  for (std::size_t i = 0; i < rows.size(); ++i)
    selected.row(static_cast<Eigen::Index>(i)) = layouts.row(rows[i]);
  return selected;
}

/// Initial value: the mean position of the marker, shifted like the row's seen markers.
void fill_by_shift(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(filled.cols()), count = mean;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (const Eigen::Index k : seen[i])
      mean[k] += filled(static_cast<Eigen::Index>(i), k), ++count[k];
  mean = mean.cwiseQuotient(count.cwiseMax(1.0));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    const auto row = static_cast<Eigen::Index>(i);
    for (const Eigen::Index k : seen[i]) shift[k % 2] += filled(row, k) - mean[k];
    shift /= 0.5 * static_cast<double>(seen[i].size());
    for (Eigen::Index k = 0; k < filled.cols(); ++k)
      if (!std::isfinite(filled(row, k))) filled(row, k) = mean[k] + shift[k % 2];
  }
}

/// One pass: the modes of all rows, then each row's gaps from its seen coordinates.
void refine(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  const Eigen::Index n = filled.rows(), size = filled.cols();
  const Eigen::VectorXd mean = filled.colwise().mean().transpose();
  const Eigen::MatrixXd centred = filled.rowwise() - mean.transpose();
  const auto eigen = symmetric_eigen(centred.transpose() * centred / static_cast<double>(n - 1));
  const Eigen::Index modes = std::min<Eigen::Index>({kMaxGapModes, n - 1, size});
  const Eigen::VectorXd values = eigen.eigenvalues().tail(modes).cwiseMax(1e-6);
  const Eigen::MatrixXd basis = eigen.eigenvectors().rightCols(modes);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (static_cast<Eigen::Index>(seen[i].size()) == size) continue;
    Eigen::MatrixXd a = (kNoisePx * kNoisePx / values.array()).matrix().asDiagonal();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(modes);
    for (const Eigen::Index k : seen[i]) {
      a.noalias() += basis.row(k).transpose() * basis.row(k);
      b.noalias() += basis.row(k).transpose() * centred(row, k);
    }
    const Eigen::VectorXd layout = mean + basis * a.ldlt().solve(b);
    std::size_t next = 0;
    for (Eigen::Index k = 0; k < size; ++k) {
      if (next < seen[i].size() && seen[i][next] == k)
        ++next;
      else
        filled(row, k) = layout[k];
    }
  }
}

/// Fills gaps from the nearest rows, which follow the bending where one set of modes cannot
/// (local_layout.h).
void refine_locally(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  const Eigen::MatrixXd before = filled;
  std::vector<char> without(seen.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (static_cast<Eigen::Index>(seen[i].size()) == filled.cols()) continue;
    without[i] = 1;
    const auto neighbours =
        nearest_rows(before, before.row(row).transpose(), kLocalNeighbours, without);
    without[i] = 0;
    if (neighbours.size() < 2) continue;
    Markers markers(static_cast<std::size_t>(filled.cols() / 2));
    for (const Eigen::Index k : seen[i])
      markers[static_cast<std::size_t>(k / 2)] = {
          before(row, k / 2 * 2), before(row, k / 2 * 2 + 1), true, 0};
    const LocalLayout local(before, neighbours, markers, kNoisePx);
    for (std::size_t m = 0; m < markers.size(); ++m)
      if (!markers[m].seen)
        filled.row(row).segment<2>(static_cast<Eigen::Index>(2 * m)) =
            local.position(static_cast<int>(m)).transpose();
  }
}

}  // namespace

Eigen::MatrixXd without_gaps(const Eigen::MatrixXd& layouts) {
  std::vector<Eigen::Index> complete, usable;
  std::vector<std::vector<Eigen::Index>> seen;
  Eigen::VectorXi count = Eigen::VectorXi::Zero(layouts.cols());
  for (Eigen::Index i = 0; i < layouts.rows(); ++i) {
    auto coordinates = seen_coordinates(layouts, i);
    const auto known = static_cast<Eigen::Index>(coordinates.size());
    if (known == layouts.cols()) complete.push_back(i);
    if (known < 4 || 2 * known < layouts.cols()) continue;
    usable.push_back(i);
    for (const Eigen::Index k : coordinates) ++count[k];
    seen.push_back(std::move(coordinates));
  }
  const bool is_plenty = complete.size() >= kEnoughRows && 3 * complete.size() >= 2 * usable.size();
  if (complete.size() >= 2 && (is_plenty || complete.size() == usable.size()))
    return rows_of(layouts, complete);
  if (usable.size() < 2 || count.minCoeff() == 0) return rows_of(layouts, {});
  Eigen::MatrixXd filled = rows_of(layouts, usable);
  fill_by_shift(seen, filled);
  for (int pass = 0; pass < kPasses; ++pass) refine(seen, filled);
  for (int pass = 0; pass < kLocalPasses; ++pass) refine_locally(seen, filled);
  return filled;
}

}  // namespace alltact
