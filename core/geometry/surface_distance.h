// Distance between two surfaces.
#pragma once

#include "core/geometry/rigid_transform.h"

#include <array>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

// Distance between two triangles.

using Triangle = std::array<Eigen::Vector3d, 3>;

/// One point on each of two objects, nearest to each other; equal where the objects intersect.
struct NearestPoints {
  Eigen::Vector3d first, second;
  [[nodiscard]] double distance() const { return (second - first).norm(); }
};

/// After Ericson, Real-Time Collision Detection (2005), 5.1. Triangles may be degenerate.
[[nodiscard]] NearestPoints nearest_points(const Triangle& first, const Triangle& second);

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
