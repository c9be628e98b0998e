// How near two triangles come to each other.
#pragma once

#include <array>

#include <Eigen/Core>

namespace alltact {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// A point of each of two things, nearest to each other; the same point where they meet.
struct NearestPoints {
  Eigen::Vector3d first, second;
  [[nodiscard]] double distance() const { return (second - first).norm(); }
};

/// After Ericson, Real-Time Collision Detection (2005), 5.1. Triangles may be degenerate.
[[nodiscard]] NearestPoints nearest_points(const Triangle& first, const Triangle& second);

}  // namespace alltact
