// How a Fin Ray finger lies in every picture, as the scene's bend and sway say it.
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

/// Least squares of the middle line's z and y at the columns' rays. The base is where the first
/// shape begins to be seen: s counts from there. Errors: the base is on the right of the picture,
/// where no scene has it; a shape with too few columns; a line that no bend comes near.
[[nodiscard]] Result<TwinPoses> fit_poses(const std::vector<const FaceShape*>& shapes,
                                          const Job& job);

/// The place on the untouched outer side under a ball's centre, as the effect `ball` says it (s,
/// y); of a flat sensor x and y.
[[nodiscard]] Eigen::Vector2d place_under(const TwinScene& scene,
                                          const TwinPose& pose,
                                          const Eigen::Vector3d& ball_mm);

}  // namespace alltact
