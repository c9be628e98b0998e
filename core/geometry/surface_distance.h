// How near two surfaces come to each other.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/geometry/triangle_distance.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// A grid of points as a surface: two triangles between each four of them, as write_surface() cuts
/// them.
struct PlacedSurface {
  cv::Mat points_mm;     ///< CV_32FC3; triangles with a point that is not finite are left out
  RigidTransform place;  ///< to the frame in which is measured
};

/// The nearest points of the two surfaces themselves, not of their vertices, in the common frame;
/// nullopt where one of them has no triangle. Exact for the triangles but for a part in 1e9.
[[nodiscard]] std::optional<NearestPoints> nearest_points(const PlacedSurface& first,
                                                          const PlacedSurface& second);

}  // namespace alltact
