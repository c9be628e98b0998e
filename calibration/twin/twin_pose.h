// Pose of a Fin Ray finger in every image, as the scene's bend and sway.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

struct TwinPoses {
  Eigen::Vector3d base_mm = Eigen::Vector3d::Zero();
  double incline_rad = 0, length_mm = 0;
  std::vector<TwinPose> poses;  ///< one a shape
  double rms_mm = 0;            ///< of z along the middle line
};

/// Least squares of the middle line's z and y at the columns' rays. The base is the first visible
/// point of the first shape: s counts from there. Errors: the base is on the right of the image,
/// which no scene supports; a shape with too few columns; a line that no bend fits.
[[nodiscard]] Result<TwinPoses> fit_poses(const std::vector<const FaceShape*>& shapes,
                                          const Job& job);

/// Position on the untouched outer side under a ball's centre, as the effect `ball` defines it (s,
/// y); of a flat sensor x and y.
[[nodiscard]] Eigen::Vector2d position_under(const TwinScene& scene,
                                             const TwinPose& pose,
                                             const Eigen::Vector3d& ball_mm);

}  // namespace alltact
