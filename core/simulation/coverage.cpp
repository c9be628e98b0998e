#include "core/simulation/coverage.h"

#include <algorithm>
#include <cmath>

namespace alltact {

namespace {

using Outline = std::vector<Eigen::Vector2d>;

// Clips a convex polygon to sign * coordinate <= sign * limit.
Outline clip(const Outline& polygon, int axis, double limit, double sign) {
  Outline clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (limit - a[axis]), db = sign * (limit - b[axis]);
    if (da >= 0) clipped.push_back(a);
    if ((da >= 0) != (db >= 0)) clipped.push_back(a + (b - a) * (da / (da - db)));
  }
  return clipped;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Coordinates are relative to the first corner, so that large values do not cancel.
double area(const Outline& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * std::abs(twice);
}

}  // namespace

Coverage convex_coverage(const Outline& outline, cv::Size size) {
  Eigen::Vector2d low = outline.front(), high = low;
  for (const auto& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto pixel = [](double x, int end) {
    return static_cast<int>(std::clamp(std::floor(x + 0.5), -1.0, static_cast<double>(end)));
  };
  const int u0 = std::max(0, pixel(low.x(), size.width));
  const int u1 = std::min(size.width, pixel(high.x(), size.width) + 1);
  const int v0 = std::max(0, pixel(low.y(), size.height));
  const int v1 = std::min(size.height, pixel(high.y(), size.height) + 1);
  Coverage coverage{{u0, v0}, {}};
  if (u0 >= u1 || v0 >= v1) return coverage;
  coverage.fraction = cv::Mat_<float>::zeros(v1 - v0, u1 - u0);
  for (int v = v0; v < v1; ++v) {
    const Outline strip = clip(clip(outline, 1, v - 0.5, -1), 1, v + 0.5, 1);
    if (strip.size() < 3) continue;
    for (int u = u0; u < u1; ++u) {
      const Outline cell = clip(clip(strip, 0, u - 0.5, -1), 0, u + 0.5, 1);
      if (cell.size() >= 3) coverage.fraction(v - v0, u - u0) = static_cast<float>(area(cell));
    }
  }
  return coverage;
}

Eigen::Vector2d centre_of_area(const Outline& outline) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - outline[0], b = outline[i + 1] - outline[0];
    sum += (a + b) * cross(a, b);
    weight += 3 * cross(a, b);
  }
  return outline[0] + (weight != 0 ? Eigen::Vector2d(sum / weight) : Eigen::Vector2d::Zero());
}

}  // namespace alltact
