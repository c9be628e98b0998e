// How far the faces of two fingers are from each other.
#pragma once

#include "core/gripper/gripper.h"

#include <array>
#include <functional>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A face as its finger's camera tells it.
struct GapFace {
  cv::Mat points_mm;  ///< CV_32FC3, contact_face_points_mm(): camera frame, NaN where there is none
  /// Standard deviation of the face's z in a column, mm (FaceColumn::z_sd_mm); empty or nullopt:
  /// not known.
  std::function<std::optional<double>(double u)> z_sd_mm;
  double correlated_px2 = 22.0;  ///< pixels that share their noise; 22 by the usual smoothing
};

struct FaceGap {
  double mm = 0;                        ///< below 0 where the faces' noise lets them overlap
  std::optional<double> sd_mm;          ///< absent where a face's z_sd_mm is, or in a dead point
  Eigen::Vector3d first_mm, second_mm;  ///< where, in the gripper
};

/// The least distance of both faces. The nearest of two noisy surfaces' points are those that noise
/// brought nearest; so around them (1.5 mm, or more until it holds 60 pixels) a quadric is fitted
/// to each face over the plane across the gap, and the distance taken between these. sd: of both
/// fits, by their residuals; of the faces' z, along the line of sight; of the motor, which moves
/// both. Without a quadric (fewer pixels) nullopt, and where one of them has no surface.
[[nodiscard]] std::optional<FaceGap> face_gap(const GripperPose& pose,
                                              const std::array<GapFace, 2>& faces);

}  // namespace alltact
