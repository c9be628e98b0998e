// Engraved dots on the two side faces: detection, numbering and tracking.
//
// Numbers: 0..n-1 along the upper row (small v) from base to tip, n..2n-1 along the lower row. Dots
// that a finger lacks (MarkerRows::missing) have numbers too and are never seen.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/dot.h"
#include "core/sensing/markers/dot_finder.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

class LocalLayout;

/// Finds dots on the side faces (outside the face's edges) by multi-scale blob response, sub-pixel
/// by the centroid above the local background. Stateless.
class MarkerDetector : public DotFinder {
 public:
  explicit MarkerDetector(MarkerRows rows) : rows_(rows) {}

  /// With Polarity::kAuto the polarity with the more even rows is used and reported.
  [[nodiscard]] FoundDots operator()(const cv::Mat& grey, const FaceShape& shape) const override;

 private:
  MarkerRows rows_;
};

/// Model of a finger's recorded marker motion: principal modes of all complete layouts. Numbers
/// dots, rejects dots that fit no pose, and fills in hidden markers.
class MarkerModel {
 public:
  /// layouts: one row a frame, 2n markers as (u0, v0, u1, v1, ...), px; NaN where not seen.
  /// `missing` markers (by number) have the position of their virtual dot in every row.
  /// typical_dots: mean radius and contrast of each marker. Where too few layouts are complete,
  /// gaps of those that show at least half are filled (core/sensing/markers/layout_gaps.h). Error:
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

/// Numbers the dots of one image by the model. nullopt when they fit no recorded pose; `problem` is
/// then set, where it is not null.
[[nodiscard]] std::optional<Markers> numbered(const FoundDots& found,
                                              const MarkerModel& model,
                                              Message* problem);

/// Tracks the markers from frame to frame: searches near their last positions, and detects anew
/// only when that fails. Stores the last frame.
class MarkerTracker : public MarkerFinder {
 public:
  MarkerTracker(MarkerRows rows, MarkerModel model);

  [[nodiscard]] std::optional<Markers> operator()(const cv::Mat& grey,
                                                  const FaceShape& shape,
                                                  Message* problem) override;
  void forget() override { last_.reset(); }

 private:
  [[nodiscard]] std::optional<Markers> follow(const cv::Mat& grey, const FaceShape& shape);

  MarkerDetector detector_;
  MarkerModel model_;
  std::optional<Markers> last_;
  std::vector<Dot> last_dots_;  // each marker when it was last tracked
};

}  // namespace alltact
