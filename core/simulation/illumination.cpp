#include "core/simulation/illumination.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace alltact {
namespace {

// Corners relative to the point. Clipping a quadrilateral with a plane adds one at most, and one
// more where it is not quite flat.
struct VisiblePolygon {
  std::array<Eigen::Vector3d, 6> corners;
  std::size_t n = 0;
};

VisiblePolygon clip_to_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                             const Quadrilateral& corners) {
  std::array<Eigen::Vector3d, 4> to_corner;
  std::array<double, 4> height{};
  for (std::size_t i = 0; i < 4; ++i) {
    to_corner[i] = corners[i] - point;
    height[i] = normal.dot(to_corner[i]);
  }
  VisiblePolygon visible;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (height[i] >= 0) visible.corners[visible.n++] = to_corner[i];
    if ((height[i] >= 0) == (height[next] >= 0)) continue;
    const double part = height[i] / (height[i] - height[next]);
    visible.corners[visible.n++] = to_corner[i] + part * (to_corner[next] - to_corner[i]);
  }
  return visible;
}

}  // namespace

double form_factor(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                   const Quadrilateral& corners) {
  const VisiblePolygon visible = clip_to_plane(point, normal, corners);
  if (visible.n < 3) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < visible.n; ++i) {
    const Eigen::Vector3d& a = visible.corners[i];
    const Eigen::Vector3d& b = visible.corners[(i + 1) % visible.n];
    const Eigen::Vector3d turn = b.cross(a);
    const double sine = turn.norm();
    // An edge in line with the point has no angle.
    if (sine <= 1e-14 * a.norm() * b.norm()) continue;
    sum += std::atan2(sine, a.dot(b)) * normal.dot(turn) / sine;
  }
  return std::clamp(sum / (2 * std::numbers::pi), 0.0, 1.0);
}

}  // namespace alltact
