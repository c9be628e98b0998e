// Model of a finger's recorded marker motion.
#pragma once

#include "core/base/result.h"
#include "core/sensing/markers/markers.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

class LocalLayout;

/// Model of a finger's recorded marker motion: principal modes of all complete layouts. Numbers
/// dots, rejects dots that fit no pose, and fills in hidden markers.
class MarkerModel {
 public:
  /// layouts: one row a frame, 2n markers as (u0, v0, u1, v1, ...), px; NaN where not seen.
  /// `missing` markers (by number) have the position of their virtual dot in every row.
  /// typical_dots: mean radius and contrast of each marker. Where too few layouts are complete,
  /// gaps of those that show at least half are filled. Error:
  /// fewer than 2 usable layouts.
  static Result<MarkerModel> learn(const Eigen::MatrixXd& layouts,
                                   const std::vector<Dot>& typical_dots,
                                   const std::vector<int>& missing = {});

  [[nodiscard]] int marker_count() const { return static_cast<int>(mean_.size() / 2); }

  /// Numbers dots: starts from the recorded layout that explains most of them, then alternates
  /// assignment and fit of the modes within a shrinking gate. Returns every marker, seen or
  /// estimated. nullopt when fewer than `minimum_seen` (a third of those that exist) dots fit any
  /// pose.
  [[nodiscard]] std::optional<Markers> number(const std::vector<Dot>& dots) const;

  /// Estimates unseen markers from the seen ones, and replaces markers that contradict the others
  /// (partly covered dots) by estimates. nullopt when too few are seen.
  [[nodiscard]] std::optional<Markers> complete(Markers markers) const;

  /// Covariance (4n x 4n) of the coordinates (u0, v0, u1, ...) of completed markers. Seen ones err
  /// by their own sd_px, estimates by LocalLayout::covariance_px2, correlated with the seen ones.
  /// nullopt where no marker is seen or the number of markers differs.
  [[nodiscard]] std::optional<Eigen::MatrixXd> covariance_px2(const Markers& markers) const;

  /// Coordinates of a complete layout in the modes, each divided by its standard deviation in the
  /// recording.
  [[nodiscard]] Eigen::VectorXd modes(const Markers& markers) const;
  /// Root mean square distance in px of the seen markers from the nearest layout of the modes.
  [[nodiscard]] double residual_px(const Markers& markers) const;

  /// True when the finger has no dot with this number.
  [[nodiscard]] bool is_missing(int marker) const {
    return missing_[static_cast<std::size_t>(marker)] != 0;
  }
  [[nodiscard]] int present_count() const { return present_; }
  [[nodiscard]] const std::vector<Dot>& typical_dots() const { return typical_; }
  /// Standard deviation of each mode in the recording, px; times modes() it is a distance.
  [[nodiscard]] const Eigen::VectorXd& mode_sd_px() const { return mode_sd_; }
  /// Typical distance of a seen marker from its estimate by the others, px.
  [[nodiscard]] double noise_px() const { return noise_px_; }
  /// Smallest distance of neighbouring markers of a row in the recording, px.
  [[nodiscard]] double spacing_px() const { return spacing_px_; }

 private:
  struct Pose;  // modes fitted to numbered dots
  [[nodiscard]] Eigen::VectorXd fit_modes(const Markers& markers) const;
  [[nodiscard]] Pose explain(const std::vector<Dot>& dots, Eigen::VectorXd layout) const;
  [[nodiscard]] std::vector<int> likeliest_layouts(const std::vector<Dot>& dots) const;
  [[nodiscard]] LocalLayout local_layout(const Markers& markers) const;
  [[nodiscard]] int minimum_seen() const { return std::max(2, (present_ + 2) / 3); }
  void learn_noise();

  Eigen::MatrixXd layouts_;           // complete ones, a row each
  Eigen::MatrixXd mode_coordinates_;  // coordinates of the layouts in the modes, px, a row each
  Eigen::VectorXd mean_;
  Eigen::MatrixXd basis_;  // 4n x modes, orthonormal columns
  Eigen::VectorXd mode_sd_;
  std::vector<int> covering_;  // rows of layouts_ that together are near to every other
  double noise_px_ = 0.1;
  double spacing_px_ = 10;  // smallest distance of neighbouring markers in a row
  std::vector<Dot> typical_;
  std::vector<char> missing_;
  int present_ = 0;
};

// Estimates markers from the nearest recorded layouts: an affine mixture of these follows the
// bending where one set of modes for the full recording cannot.

inline constexpr int kLocalNeighbours = 20;

/// Indices of the `count` rows of `points` nearest to `query`, nearest first. `without` (by row)
/// marks excluded rows; empty: none.
[[nodiscard]] std::vector<int> nearest_rows(const Eigen::MatrixXd& points,
                                            const Eigen::VectorXd& query, int count,
                                            const std::vector<char>& without = {});

/// The mixture (weights that sum to 1) of recorded layouts nearest to the seen markers, by ridge
/// regression. Prior: deviations from the neighbours' mean are normal with twice their own spread.
/// Markers are observed with the noise `noise_px`.
class LocalLayout {
 public:
  LocalLayout(const Eigen::MatrixXd& layouts, const std::vector<int>& neighbours,
              const Markers& markers, double noise_px);

  [[nodiscard]] Eigen::Vector2d position(int marker) const {
    return position_.segment<2>(Eigen::Index{2} * marker);
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
