// The recorded layout nearest to the markers: exactly what looking at all of them would find.
//
// Layouts are grouped round about sqrt(n) of them. With a group's centre c and, of each marker, the
// greatest distance r of its layouts from c, no layout of the group is nearer to q than
//   sum over the markers that count of max(0, |q - c| - r)
// by the triangle inequality, whichever markers count. Groups are looked through from the least of
// these bounds on until the next one lies beyond what was found.
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

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// Layouts that lie near each other.
  struct Group {
    std::size_t begin, end;       // in the order of rows_
    std::vector<float> centre;    // u0, v0, u1, ...
    std::vector<float> reach_px;  // of each marker
  };
  struct Bound {
    float least;  // sum over the markers that count
    std::size_t group;
  };
  /// One layout where it lies among those of its group.
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
  void group_round(const Eigen::MatrixXd& layouts, std::size_t count);
  [[nodiscard]] std::vector<Bound> bounds(const Markers& markers) const;

  std::size_t frames_, markers_;
  std::vector<int> rows_;  // by group, ascending within each
  std::vector<float>
      places_;  // of a group: u0 of all its layouts, v0 of all, u1 ...: loops run along
  std::vector<std::size_t> place_of_row_;  // its index in rows_
  std::vector<Group> groups_;
};

/// How far the nearest layout may be of a pose that counts as recorded: three times the median
/// step, at least 1.5 px, px.
[[nodiscard]] double known_distance_px(const LayoutSearch& search);

}  // namespace alltact
