// Distance between two surfaces.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/geometry/triangle_distance.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// A grid of points as a surface: two triangles between each four of them, as write_surface() cuts
/// them.
struct PosedSurface {
  cv::Mat points_mm;    ///< CV_32FC3; triangles with a point that is not finite are left out
  RigidTransform pose;  ///< to the common frame
};

/// The nearest points of the two surfaces themselves, not of their vertices, in the common frame.
/// nullopt: one of them has no triangle. Exact for the triangles to a part in 1e9.
[[nodiscard]] std::optional<NearestPoints> nearest_points(const PosedSurface& first,
                                                          const PosedSurface& second);

}  // namespace alltact
