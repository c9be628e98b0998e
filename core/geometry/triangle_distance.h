// Distance between two triangles.
#pragma once

#include <array>

#include <Eigen/Core>

namespace alltact {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// One point on each of two objects, nearest to each other; equal where the objects intersect.
struct NearestPoints {
  Eigen::Vector3d first, second;
  [[nodiscard]] double distance() const { return (second - first).norm(); }
};

/// After Ericson, Real-Time Collision Detection (2005), 5.1. Triangles may be degenerate.
[[nodiscard]] NearestPoints nearest_points(const Triangle& first, const Triangle& second);

}  // namespace alltact
