// The recorded layout nearest to the markers, by looking at all of them.
#pragma once

#include "core/sensing/markers/markers.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

class LayoutSearch {
 public:
  /// layouts: one row a frame, (u0, v0, u1, ...), px, at least one row, finite.
  explicit LayoutSearch(const Eigen::MatrixXd& layouts);

  struct Found {
    int row;
    double distance_px;  ///< mean over the markers that count
  };
  /// The row with the least mean distance over the markers that are seen (all, when none is). Row 0
  /// on a tie, and so on upwards. `without` (by row) marks those that take no part, empty: all do;
  /// with none left the distance is infinite.
  [[nodiscard]] Found nearest(const Markers& markers, const std::vector<char>& without = {}) const;

  /// Mean distance, over the same markers, to the sum of weights[i] times row rows[i].
  [[nodiscard]] double distance_px(const Markers& markers,
                                   const std::vector<int>& rows,
                                   const Eigen::VectorXd& weights) const;

  /// Median over the rows (at most about 200 of them) of the distance to the nearest other row.
  [[nodiscard]] double median_step_px() const;

 private:
  std::size_t frames_;
  std::vector<float>
      places_;  // u0 of all frames, v0 of all frames, u1 ...: the loops run along frames
};

/// How far the nearest layout may be of a pose that counts as recorded: three times the median
/// step, at least 1.5 px, px.
[[nodiscard]] double known_distance_px(const LayoutSearch& search);

}  // namespace alltact
