// Markers told from the recorded layouts nearest to them: an affine mixture of these, which follows
// the bending where one set of modes for the whole recording cannot.
#pragma once

#include "core/sensing/markers/markers.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

inline constexpr int kLocalNeighbours = 20;

/// Indices of the `count` rows of `points` nearest to `query`, nearest first; `without` (by row)
/// marks those that take no part, empty: all do.
[[nodiscard]] std::vector<int> nearest_rows(const Eigen::MatrixXd& points,
                                            const Eigen::VectorXd& query,
                                            int count,
                                            const std::vector<char>& without = {});

/// The mixture (weights that sum to 1) of recorded layouts that lies nearest to the markers seen,
/// by ridge regression: deviations from the neighbours' mean are drawn from a normal distribution
/// with twice their own spread, and markers are seen with `noise_px`.
class LocalLayout {
 public:
  LocalLayout(const Eigen::MatrixXd& layouts,
              const std::vector<int>& neighbours,
              const Markers& markers,
              double noise_px);

  [[nodiscard]] Eigen::Vector2d place(int marker) const { return place_.segment<2>(2 * marker); }
  /// Standard deviation of u and of v that the mixture leaves open (the larger of the two).
  [[nodiscard]] double sd_px(int marker) const;

  /// How far a marker that took part lies from what the other markers tell of it: in px, and in
  /// standard deviations. A single residual hides that, because a marker at the end of a row pulls
  /// the mixture to itself.
  struct Discrepancy {
    double px, sigmas;
  };
  [[nodiscard]] Discrepancy discrepancy(int marker, const Eigen::Vector2d& seen) const;
  /// What the fit leaves, in squared standard deviations; without a marker it falls by the square
  /// of that marker's discrepancy.
  [[nodiscard]] double misfit() const { return misfit_; }
  /// Covariance of a layout (4n x 4n) of the markers seen and, for the others, place(): seen ones
  /// err by their own sd_px, estimated ones by what that and the recording's noise make of the
  /// mixture, by the mixture's pull to the neighbours' mean, and by what no mixture follows.
  /// `markers` are those that the mixture was told from.
  [[nodiscard]] Eigen::MatrixXd covariance_px2(const Markers& markers) const;

 private:
  double noise_px_, misfit_ = 0;
  Eigen::MatrixXd deviations_;  // 4n x neighbours
  Eigen::MatrixXd covariance_;  // of the deviations' coefficients
  Eigen::VectorXd place_;
};

}  // namespace alltact
