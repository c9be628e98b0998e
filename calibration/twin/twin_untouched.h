// Pose of a Fin Ray finger in every image, as the scene's bend and sway.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

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
[[nodiscard]] Eigen::Vector2d position_under(const TwinScene& scene, const TwinPose& pose,
                                             const Eigen::Vector3d& ball_mm);

// Lamps that reproduce the light of a finger.

/// An untouched image.
struct TwinUntouched {
  TwinPose pose;
  cv::Mat grey;  ///< CV_32FC1; NaN where it has no information
};

/// Standard deviations of one lamp's numbers; empty: the images do not determine them.
struct LampSpread {
  std::optional<Eigen::Vector3d> at_mm;
  std::optional<double> power;
};

struct TwinLamps {
  std::vector<TwinLamp> lamps;
  double room_level = 0;
  std::vector<LampSpread> spread;  ///< one a lamp
  double rms = 0;                  ///< of block means, grey levels
};

inline constexpr std::size_t kMaxLamps = 8;

/// Needs a scene with final camera, face and layer. Lamps are added one by one from a grid about
/// the face, aimed along it, while each reduces the residual by a thirtieth, and are then moved
/// together. Errors: nothing to compare; the scene cannot be rendered; stopped.
[[nodiscard]] Result<TwinLamps> fit_lamps(const TwinScene& scene,
                                          const std::vector<TwinUntouched>& untouched,
                                          const Job& job);

}  // namespace alltact
