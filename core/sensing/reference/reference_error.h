// Drift of a recording's light, and the error of references that are computed from the recording.
#pragma once

#include "core/sensing/reference/face_image.h"

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

constexpr int kErrorCellPx = 4;  ///< a side, in pixels of the grid

/// Error of references, estimated by leave-one-out: recorded frames are computed from their
/// neighbours.
struct ReferenceError {
  /// CV_32FC1 over cells of the grid: sd of the reference's brightness relative to it. Excludes
  /// noise and what the correction of the light removes. Applies to a pose at the typical distance
  /// of a recorded frame from its neighbours.
  cv::Mat relative_sd;
  double typical_reach_px2 = 0;  ///< median of reach_px2() over the recorded frames

  /// Factor of relative_sd for a frame of another reach. Half of it (in squares) remains however
  /// near the neighbours are, because the skin is never registered perfectly.
  [[nodiscard]] double factor(double reach_px2) const;
};

/// Distance of a pose from the neighbours it is computed from, px^2: sum |w_i| |p_i - pose|^2, with
/// which the error of a local linear regression grows. To it comes the residual of the pose times
/// the neighbours' distance.
[[nodiscard]] double reach_px2(const Eigen::MatrixXd& points,
                               const Eigen::VectorXd& pose,
                               const Eigen::VectorXd& weights);

/// Removes the drift of lamps: the light of every recorded face is corrected to a smooth function
/// of the pose (`modes`, a row per frame, largest variance first). Requires 12 frames; with fewer
/// nothing changes.
void remove_drift(const FaceGrid& grid,
                  const Eigen::MatrixXd& modes,
                  std::vector<FaceImage>& faces);

/// Rows and weights from which a frame is computed, itself left out.
struct Neighbours {
  std::vector<int> rows;
  Eigen::VectorXd weights;
  double reach_px2 = 0;
};
/// `neighbours_of` frame i must be thread safe.
[[nodiscard]] ReferenceError reference_error(const FaceGrid& grid,
                                             const std::vector<FaceImage>& faces,
                                             const std::function<Neighbours(int)>& neighbours_of);

}  // namespace alltact
