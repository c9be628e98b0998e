// Estimates markers from the nearest recorded layouts: an affine mixture of these follows the
// bending where one set of modes for the full recording cannot.
#pragma once

#include "core/sensing/markers/markers.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

inline constexpr int kLocalNeighbours = 20;

/// Indices of the `count` rows of `points` nearest to `query`, nearest first. `without` (by row)
/// marks excluded rows; empty: none.
[[nodiscard]] std::vector<int> nearest_rows(const Eigen::MatrixXd& points,
                                            const Eigen::VectorXd& query,
                                            int count,
                                            const std::vector<char>& without = {});

/// The mixture (weights that sum to 1) of recorded layouts nearest to the seen markers, by ridge
/// regression. Prior: deviations from the neighbours' mean are normal with twice their own spread.
/// Markers are observed with the noise `noise_px`.
class LocalLayout {
 public:
  LocalLayout(const Eigen::MatrixXd& layouts,
              const std::vector<int>& neighbours,
              const Markers& markers,
              double noise_px);

  [[nodiscard]] Eigen::Vector2d position(int marker) const {
    return position_.segment<2>(2 * marker);
  }
  /// Standard deviation of u and of v in the mixture (the larger of the two).
  [[nodiscard]] double sd_px(int marker) const;

  /// Leave-one-out residual of a used marker: its distance from the estimate by the other markers,
  /// in px and in standard deviations. A plain residual hides it, because a marker at the end of a
  /// row attracts the mixture.
  struct Discrepancy {
    double px, sigmas;
  };
  [[nodiscard]] Discrepancy discrepancy(int marker, const Eigen::Vector2d& seen) const;
  /// Residual of the fit, in squared standard deviations; without a marker it drops by the square
  /// of that marker's discrepancy.
  [[nodiscard]] double misfit() const { return misfit_; }
  /// Covariance (4n x 4n) of a layout of the seen markers and, for the others, position(). Seen
  /// ones err by their own sd_px. Estimated ones err by the propagated noise, by the mixture's bias
  /// to the neighbours' mean, and by deviations that no mixture follows. `markers`: those the
  /// mixture was fitted to.
  [[nodiscard]] Eigen::MatrixXd covariance_px2(const Markers& markers) const;

 private:
  double noise_px_, misfit_ = 0;
  Eigen::MatrixXd deviations_;  // 4n x neighbours
  Eigen::MatrixXd covariance_;  // of the deviations' coefficients
  Eigen::VectorXd position_;
};

}  // namespace alltact
