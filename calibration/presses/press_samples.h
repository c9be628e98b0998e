// A press reduced to block means on the face: the input of the fits.
#pragma once

#include "calibration/presses/press.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// One block of pixels: the mean difference, and the untouched face at its middle.
struct Sample {
  Eigen::Vector2d pixel;
  Eigen::Vector3d untouched_z;  ///< outer side of the layer along z, mm
  Eigen::Vector3d untouched_n;  ///< the same along the normal, mm
  Eigen::Vector3d normal;       ///< outward, away from the camera
  /// Derivative of untouched_n by the pixel, mm; set by sample_around() only.
  Eigen::Vector3d by_u = Eigen::Vector3d::Zero(), by_v = Eigen::Vector3d::Zero();
  double cos_incline = 1;
  double x = 0;
  Eigen::Vector2d position_mm;  ///< along the face and across it (FaceShape::position_mm)
  Eigen::Vector2d unit_position = Eigen::Vector2d::Zero();  ///< within a PressedArea, -1 to 1
};

/// A point in the image where the line of sight grazes the ball (see tangent_arc.h).
struct OutlinePoint {
  Eigen::Vector3d direction;  ///< of the ray from the camera's centre, any length
  double sd_rad = 0;          ///< of the angle to the ball's centre
};

struct PressSamples {
  std::vector<Sample> samples;        ///< by rows, then columns; only blocks completely on the face
  std::vector<OutlinePoint> outline;  ///< empty where the ball occludes no part of itself
  double ball_radius_mm = 0;
  int block_px = 1;
  /// Variance of the averaging of each sample along either axis, by smoothing and block, px^2.
  double blur_px2 = 0;
  std::optional<GivenDepth> given_depth = std::nullopt;
  double x_sd = 0;  ///< noise of a block's mean, from second differences along rows
};

/// The rectangle of the face, mm along and across it, that contains the samples.
struct PressedArea {
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero(), half_mm = Eigen::Vector2d::Ones();
};
[[nodiscard]] PressedArea pressed_area(const std::vector<const PressSamples*>& presses);
/// Sets `unit_position` of every sample.
void set_unit_positions(const PressedArea& part, PressSamples* press);

/// Block means of side `block_px`. A block with an unmeasured pixel is left out.
[[nodiscard]] PressSamples sample_press(const Press& press, const Face& face, int block_px);

/// The sample whose untouched_n is nearest to a point; null without samples.
[[nodiscard]] const Sample* nearest_sample(const PressSamples& press,
                                           const Eigen::Vector3d& point_mm);

/// The blocks within `radius_mm` of `middle` (camera frame, measured from untouched_n). Their size
/// is the smallest from 2 px on that gives at most about `limit` of them.
[[nodiscard]] PressSamples sample_around(const Press& press,
                                         const Face& face,
                                         const Eigen::Vector3d& middle,
                                         double radius_mm,
                                         int limit);

}  // namespace alltact
