// Exact search for the recorded layout nearest to the markers.
//
// Layouts are in about sqrt(n) groups. With a group's centre c and, of each marker, the largest
// distance r of its layouts from c, no layout of the group is nearer to q than
//   sum over the markers that count of max(0, |q - c| - r)
// by the triangle inequality, for any choice of markers. Groups are searched in the order of these
// bounds until the next bound exceeds the best distance.
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
  /// The row with the smallest mean distance over the seen markers (all, when none is seen). The
  /// lowest row wins a tie. `without` (by row) marks excluded rows; empty: none. Without any row
  /// left the distance is infinite.
  [[nodiscard]] Found nearest(const Markers& markers, const std::vector<char>& without = {}) const;

  /// Mean distance, over the same markers, to the sum of weights[i] times row rows[i].
  [[nodiscard]] double distance_px(const Markers& markers,
                                   const std::vector<int>& rows,
                                   const Eigen::VectorXd& weights) const;

  /// Median over the rows (about 200 of them at most) of the distance to the nearest other row.
  [[nodiscard]] double median_step_px() const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// A group of neighbouring layouts.
  struct Group {
    std::size_t begin, end;       // indices into rows_
    std::vector<float> centre;    // u0, v0, u1, ...
    std::vector<float> reach_px;  // largest distance from the centre, by marker
  };
  struct Bound {
    float lower_bound;  // sum over the markers that count
    std::size_t group;
  };
  /// View of one layout within the storage of its group.
  struct Stored {
    const float* first;
    std::size_t step;
    [[nodiscard]] double u(std::size_t marker) const {
      return static_cast<double>(first[2 * marker * step]);
    }
    [[nodiscard]] double v(std::size_t marker) const {
      return static_cast<double>(first[(2 * marker + 1) * step]);
    }
  };
  [[nodiscard]] Stored stored(std::size_t row) const;
  void group_layouts(const Eigen::MatrixXd& layouts, std::size_t count);
  [[nodiscard]] std::vector<Bound> bounds(const Markers& markers) const;

  std::size_t frames_, markers_;
  std::vector<int> rows_;  // by group, ascending within each
  std::vector<float>
      coordinates_;  // by group: u0 of all its layouts, v0 of all, u1 ...: contiguous for loops
  std::vector<std::size_t> index_of_row_;  // index in rows_, by row
  std::vector<Group> groups_;
};

/// Largest distance of the nearest layout at which a pose counts as recorded, px: three times the
/// median step, at least 1.5 px.
[[nodiscard]] double known_distance_px(const LayoutSearch& search);

}  // namespace alltact
