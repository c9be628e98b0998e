// Distance between the faces of two fingers.
#pragma once

#include "core/gripper/gripper.h"

#include <array>
#include <functional>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A face as its finger's camera measures it.
struct GapFace {
  cv::Mat points_mm;  ///< CV_32FC3, contact_face_points_mm(): camera frame, NaN off the face
  /// Standard deviation of the face's z in a column, mm (FaceColumn::z_sd_mm); empty or nullopt:
  /// unknown.
  std::function<std::optional<double>(double u)> z_sd_mm;
  double correlated_px2 = 22.0;  ///< pixels that share their noise; 22 for the default smoothing
};

struct FaceGap {
  double mm = 0;                        ///< below 0 where the faces' noise lets them overlap
  std::optional<double> sd_mm;          ///< empty where a face's z_sd_mm is, or in a dead point
  Eigen::Vector3d first_mm, second_mm;  ///< nearest points, in the gripper
};

/// The minimum distance of both faces. The nearest points of two noisy surfaces are biased by
/// noise. A quadric is therefore fitted to each face around them, over the plane across the gap. It
/// uses 1.5 mm around, or more until that holds 60 pixels; the distance is taken between the
/// quadrics. The sd combines both fits (from their residuals), the faces' z along the line of
/// sight, and the motor, which moves both. nullopt: a face has too few pixels for a quadric, or no
/// surface.
[[nodiscard]] std::optional<FaceGap> face_gap(const GripperPose& pose,
                                              const std::array<GapFace, 2>& faces);

}  // namespace alltact
