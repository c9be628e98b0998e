#include "core/geometry/triangle_distance.h"

#include <algorithm>
#include <optional>

#include <Eigen/Geometry>

namespace alltact {
namespace {

using Point = Eigen::Vector3d;

Point nearest_on_segment(const Point& a, const Point& b, const Point& p) {
  const Point along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 <= 0) return a;
  return a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along;
}

/// Ericson 5.1.5: inside, or the nearest edge.
Point nearest_on_triangle(const Triangle& t, const Point& p) {
  const Point ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  const Point bp = p - t[1], cp = p - t[2];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (va > 0 && vb > 0 && vc > 0 && sum > 0) return t[0] + (vb / sum) * ab + (vc / sum) * ac;
  Point best = nearest_on_segment(t[0], t[1], p);
  for (const Point& other : {nearest_on_segment(t[1], t[2], p), nearest_on_segment(t[2], t[0], p)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  return best;
}

/// Ericson 5.1.9.
NearestPoints nearest_of_segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point first = b - a, second = d - c, between = a - c;
  const double aa = first.squaredNorm(), ee = second.squaredNorm();
  const double f = second.dot(between);
  if (aa <= 0) return {a, nearest_on_segment(c, d, a)};
  if (ee <= 0) return {nearest_on_segment(a, b, c), c};
  const double ab = first.dot(second), ac = first.dot(between);
  const double sine2 = aa * ee - ab * ab;
  double s = sine2 > 0 ? std::clamp((ab * f - ac * ee) / sine2, 0.0, 1.0) : 0.0;
  const double t = (ab * s + f) / ee;
  if (t < 0) return {a + std::clamp(-ac / aa, 0.0, 1.0) * first, c};
  if (t > 1) return {a + std::clamp((ab - ac) / aa, 0.0, 1.0) * first, d};
  return {a + s * first, c + t * second};
}

/// The point where a segment crosses a triangle.
std::optional<Point> crossing(const Triangle& t, const Point& from, const Point& to) {
  const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double before = normal.dot(from - t[0]), behind = normal.dot(to - t[0]);
  if (before * behind > 0 || before == behind) return std::nullopt;
  const Point at = from + before / (before - behind) * (to - from);
  for (std::size_t i = 0; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).cross(at - t[i]).dot(normal) < 0) return std::nullopt;
  return at;
}

}  // namespace

NearestPoints nearest_points(const Triangle& first, const Triangle& second) {
  NearestPoints best{first[0], second[0]};
  const auto offer = [&](const NearestPoints& other) {
    if ((other.second - other.first).squaredNorm() < (best.second - best.first).squaredNorm())
      best = other;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (const auto at = crossing(second, first[i], first[next])) return {*at, *at};
    if (const auto at = crossing(first, second[i], second[next])) return {*at, *at};
    offer({first[i], nearest_on_triangle(second, first[i])});
    offer({nearest_on_triangle(first, second[i]), second[i]});
    for (std::size_t j = 0; j < 3; ++j)
      offer(nearest_of_segments(first[i], first[next], second[j], second[(j + 1) % 3]));
  }
  return best;
}

}  // namespace alltact
