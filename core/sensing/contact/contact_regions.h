// What presses where: connected regions of the depth map, in millimetres.
#pragma once

#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/local_depth.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct ContactRegion {
  Eigen::Vector3d place_mm;  ///< depth-weighted centre on the pressed face, camera frame
  Eigen::Vector2d place_px;  ///< the same in the picture
  Eigen::Vector2d place_on_face_mm = {
      0, 0};  ///< the same along the face and across it (FaceShape::place_mm)
  Eigen::Vector3d deepest_point_mm;
  double deepest_mm = 0;  ///< greatest depth
  double area_mm2 = 0;    ///< on the face
  double volume_mm3 = 0;  ///< displaced, along z
  int pixels = 0;
  /// Principal axis on the face from the finger's length (base to tip) towards +y, in
  /// (-90, 90]; absent when the region is round, or the sd above 15 degrees.
  std::optional<double> angle_deg;
  std::optional<double> angle_sd_deg;  ///< from the depth's noise alone
};

struct RegionOptions {
  double threshold_mm = 0.1;  ///< depth that counts as touched
  double noise_mm = 0.0;      ///< sd of a pixel's depth; the threshold is at least 4 of it
  double minimum_area_mm2 = 0.25;
  double correlated_px2 = 1.0;  ///< pixels that share their noise, by the smoothing
  /// How far off untouched skin may be told at a pixel (u, v), as DepthError::untouched; empty: by
  /// noise_mm everywhere.
  std::function<UntouchedSd(int, int)> untouched;
};

/// Regions ordered by volume, largest first. A cell is touched where its mean depth is above the
/// threshold and at least 4 times what noise and reference can make of untouched skin there:
/// sd^2 = noise^2 / n + systematic^2, n its independent pixels (one in correlated_px2). A
/// region's mean depth must be that, too, with n its own.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const DepthMap& depth,
                                                         const FaceShape& shape,
                                                         const Face& face,
                                                         const RegionOptions& options);

}  // namespace alltact
