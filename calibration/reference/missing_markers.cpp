#include "calibration/reference/missing_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alltact {
namespace {

constexpr std::size_t kNodes = 3;

/// Existing markers of the same row, nearest by number first.
std::vector<int> nodes_of(int marker, const std::vector<int>& missing, int per_row) {
  const int first = marker / per_row * per_row;
  std::vector<int> nodes;
  for (int m = first; m < first + per_row; ++m)
    if (!std::binary_search(missing.begin(), missing.end(), m)) nodes.push_back(m);
  std::stable_sort(nodes.begin(), nodes.end(), [marker](int a, int b) {
    return std::abs(a - marker) < std::abs(b - marker);
  });
  if (nodes.size() > kNodes) nodes.resize(kNodes);
  return nodes;
}

}  // namespace

void interpolate_missing(const std::vector<int>& missing,
                         const MirroredPosition& mirrored,
                         Eigen::MatrixXd& layouts,
                         Eigen::Index row) {
  const int per_row = static_cast<int>(layouts.cols() / 4);
  for (const int marker : missing) {
    std::vector<int> nodes = nodes_of(marker, missing, per_row);
    const bool by_other_side = nodes.size() < 2;
    if (by_other_side) {
      nodes = nodes_of((marker + per_row) % (2 * per_row), missing, per_row);
      for (int& node : nodes) node = (node + per_row) % (2 * per_row);
    }
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    bool is_known = !nodes.empty();
    for (const int node : nodes) {
      double weight = 1.0;  // Lagrange's
      for (const int other : nodes)
        if (other != node) weight *= static_cast<double>(marker - other) / (node - other);
      std::optional<Eigen::Vector2d> at = layouts.row(row).segment<2>(2 * node).transpose();
      if (by_other_side) at = mirrored(node);
      is_known = is_known && at;
      if (at) position += weight * *at;
    }
    if (is_known) layouts.row(row).segment<2>(2 * marker) = position.transpose();
  }
}

}  // namespace alltact
