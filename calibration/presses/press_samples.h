// A press thinned to block means on the face: what the fits read.
#pragma once

#include "calibration/presses/press.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// One block of pixels: the mean difference, and the untouched face above its middle.
struct Sample {
  Eigen::Vector2d pixel;
  Eigen::Vector3d untouched_z;  ///< outer side of the layer along z, mm
  Eigen::Vector3d untouched_n;  ///< the same along the normal, mm
  Eigen::Vector3d normal;       ///< outward, away from the camera
  /// How untouched_n moves from pixel to pixel, mm; only sample_around() tells that.
  Eigen::Vector3d by_u = Eigen::Vector3d::Zero(), by_v = Eigen::Vector3d::Zero();
  double cos_incline = 1;
  double x = 0;
  Eigen::Vector2d place_mm;  ///< along the face and across it (FaceShape::place_mm)
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< the same within a PressedPart, -1 to 1
};

/// A place in the picture where the line of sight grazes the ball (see tangent_arc.h).
struct OutlinePoint {
  Eigen::Vector3d direction;  ///< of the ray from the camera's centre, any length
  double sd_rad = 0;          ///< of the angle to the ball's centre
};

struct PressSamples {
  std::vector<Sample> samples;  ///< by rows, then columns; only blocks that lie wholly on the face
  std::vector<OutlinePoint> outline;  ///< empty where no part of the ball hides another
  double ball_radius_mm = 0;
  int block_px = 1;
  /// Every sample is a mean over a part of the picture: that part's variance along either axis, by
  /// smoothing and block.
  double blur_px2 = 0;
  std::optional<ToldDepth> told_depth = std::nullopt;
  double x_sd = 0;  ///< noise of a block's mean, from second differences along rows
};

/// The rectangle of the face, mm along and across it, in which there are samples.
struct PressedPart {
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero(), half_mm = Eigen::Vector2d::Ones();
};
[[nodiscard]] PressedPart pressed_part(const std::vector<const PressSamples*>& presses);
/// Sets `place` of every sample.
void place_within(const PressedPart& part, PressSamples* press);

/// Block means of side `block_px`. A block with any pixel that has no measurement is left out.
[[nodiscard]] PressSamples sample_press(const Press& press, const Face& face, int block_px);

/// The sample whose untouched_n lies nearest to a point; null where there is none.
[[nodiscard]] const Sample* nearest_sample(const PressSamples& press,
                                           const Eigen::Vector3d& point_mm);

/// The blocks within `radius_mm` of `middle` (camera frame, measured from untouched_n), of the
/// smallest size from 2 px on that gives at most about `limit` of them.
[[nodiscard]] PressSamples sample_around(const Press& press,
                                         const Face& face,
                                         const Eigen::Vector3d& middle,
                                         double radius_mm,
                                         int limit);

}  // namespace alltact
