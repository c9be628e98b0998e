// What a recording says of itself: how its light drifted, and how far off a reference is that is
// computed from it.
#pragma once

#include "core/sensing/reference/face_picture.h"

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

constexpr int kErrorCellPx = 4;  ///< a side, in pixels of the grid

/// How far off references are, learnt by computing recorded frames from their neighbours without
/// themselves.
struct ReferenceError {
  /// CV_32FC1 over cells of the grid: sd of the reference's brightness relative to it, without
  /// noise and without what the correction of the light takes out; for a pose as far from its
  /// neighbours as the recorded frames are from theirs.
  cv::Mat relative_sd;
  double typical_reach_px2 = 0;  ///< of reach_px2() over the recorded frames

  /// By what relative_sd is to be multiplied for a frame of another reach: half of it (in squares)
  /// stays however near the neighbours are, as the skin is never followed perfectly.
  [[nodiscard]] double factor(double reach_px2) const;
};

/// How far a pose lies from the neighbours it is computed from: sum |w_i| |p_i - pose|^2, which the
/// error of a local linear regression grows with, and what the weights miss of the pose times the
/// neighbours' distance. px^2.
[[nodiscard]] double reach_px2(const Eigen::MatrixXd& points,
                               const Eigen::VectorXd& pose,
                               const Eigen::VectorXd& weights);

/// Takes out of every recorded face what its light differs by from a smooth function of the pose
/// (`modes`, a row a frame, most varied first): lamps that drift while recording. Needs 12 frames;
/// with fewer nothing is changed.
void take_out_drift(const FaceGrid& grid,
                    const Eigen::MatrixXd& modes,
                    std::vector<FacePicture>& faces);

/// Rows and weights that a frame is computed from, itself left out.
struct Neighbours {
  std::vector<int> rows;
  Eigen::VectorXd weights;
  double reach_px2 = 0;
};
/// `neighbours_of` frame i, asked by several threads at once.
[[nodiscard]] ReferenceError reference_error(const FaceGrid& grid,
                                             const std::vector<FacePicture>& faces,
                                             const std::function<Neighbours(int)>& neighbours_of);

}  // namespace alltact
