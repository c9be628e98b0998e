#include "core/simulation/form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace alltact {

namespace {

// Corners as seen from the point; cutting a quadrilateral with a plane adds one at most, and one
// more where it is not quite flat.
struct SeenPolygon {
  std::array<Eigen::Vector3d, 6> corners;
  std::size_t n = 0;
};

SeenPolygon above_the_plane(const Eigen::Vector3d& point,
                            const Eigen::Vector3d& normal,
                            const Quadrilateral& corners) {
  std::array<Eigen::Vector3d, 4> way;
  std::array<double, 4> height{};
  for (std::size_t i = 0; i < 4; ++i) {
    way[i] = corners[i] - point;
    height[i] = normal.dot(way[i]);
  }
  SeenPolygon seen;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (height[i] >= 0) seen.corners[seen.n++] = way[i];
    if ((height[i] >= 0) == (height[next] >= 0)) continue;
    const double part = height[i] / (height[i] - height[next]);
    seen.corners[seen.n++] = way[i] + part * (way[next] - way[i]);
  }
  return seen;
}

}  // namespace

double form_factor(const Eigen::Vector3d& point,
                   const Eigen::Vector3d& normal,
                   const Quadrilateral& corners) {
  const SeenPolygon seen = above_the_plane(point, normal, corners);
  if (seen.n < 3) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < seen.n; ++i) {
    const Eigen::Vector3d& a = seen.corners[i];
    const Eigen::Vector3d& b = seen.corners[(i + 1) % seen.n];
    const Eigen::Vector3d turn = b.cross(a);
    const double sine = turn.norm();
    // An edge that points at the point is seen as none.
    if (sine <= 1e-14 * a.norm() * b.norm()) continue;
    sum += std::atan2(sine, a.dot(b)) * normal.dot(turn) / sine;
  }
  return std::clamp(sum / (2 * std::numbers::pi), 0.0, 1.0);
}

}  // namespace alltact
