#include "core/sensing/markers/marker_rows.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kColumnStride = 4;  // columns

/// Intersection of a ray with the plane y = edge_y; nullopt behind the camera or without one.
std::optional<Eigen::Vector3d> on_side_face(const Ray& ray, double edge_y_mm) {
  if (std::abs(ray.direction.y()) < 1e-6) return std::nullopt;
  const double z = (edge_y_mm - ray.origin_mm.y()) / ray.direction.y();
  if (!(z > 0.0 && z < 1e5)) return std::nullopt;
  return ray.point_at(z);
}

/// The face in side view: a polyline in x and z, with y of both edges.
class Profile {
 public:
  Profile(const FaceShape& shape, const SideEdges& edges) {
    for (int u = kColumnStride / 2; u < shape.width_px(); u += kColumnStride) {
      const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
      if (!column.valid) continue;
      const auto upper = shape.camera().unproject({u, edges.upper[static_cast<std::size_t>(u)]});
      const auto lower = shape.camera().unproject({u, edges.lower[static_cast<std::size_t>(u)]});
      if (!upper || !lower) continue;
      const Eigen::Vector3d a = upper->point_at(column.z_mm), b = lower->point_at(column.z_mm);
      points_.push_back({0.5 * (a.x() + b.x()), column.z_mm, a.y(), b.y(), shape.length_at(u)});
    }
  }
  [[nodiscard]] bool is_empty() const { return points_.size() < 2; }

  struct Foot {
    double along_mm = 0, off_mm = 0, z_mm = 0;
  };
  /// Foot of the ray's intersection with the side face: the point of the face whose normal passes
  /// through it. The profile continues straight beyond its ends. Of several feet the one nearest to
  /// the intersection is returned. off_mm > 0 towards the camera. nullopt: there is none.
  [[nodiscard]] std::optional<Foot> foot(const Ray& ray, bool upper) const {
    std::optional<Foot> best;
    std::optional<Intersection> before;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto intersection = intersect(ray, i, upper);
      const bool first = i == 1, last = i + 1 == points_.size();
      if (intersection && before && intersection->ahead_mm != before->ahead_mm) {
        const double t = before->ahead_mm / (before->ahead_mm - intersection->ahead_mm);
        // The offset along the tangent changes sign at the foot.
        const bool is_inside = t >= 0.0 && t <= 1.0;
        if (is_inside || (first && t < 0.0 && t > -kBeyond) || (last && t > 1.0 && t < kBeyond)) {
          const Foot foot = between(*before, *intersection, i, t);
          if (!best || std::abs(foot.off_mm) < std::abs(best->off_mm)) best = foot;
        }
      }
      before = intersection;
    }
    return best;
  }

 private:
  struct Point {
    double x, z, upper_y, lower_y, along_mm;
  };
  struct Intersection {
    double ahead_mm, off_mm, z_mm;
  };
  static constexpr double kBeyond = 60.0;  // steps of the profile beyond its ends

  /// Intersection of the ray with the plane y of the edge, relative to one point of the face.
  [[nodiscard]] std::optional<Intersection> intersect(const Ray& ray,
                                                      std::size_t i,
                                                      bool upper) const {
    const Point& p = points_[i];
    const auto at = on_side_face(ray, upper ? p.upper_y : p.lower_y);
    if (!at) return std::nullopt;
    const Point &a = points_[i > 0 ? i - 1 : 0], &b = points_[std::min(i + 1, points_.size() - 1)];
    Eigen::Vector2d tangent(b.x - a.x, b.z - a.z);
    if (!(tangent.norm() > 0)) return std::nullopt;
    tangent.normalize();
    const Eigen::Vector2d away(at->x() - p.x, at->z() - p.z);
    const double across = tangent.x() * away.y() - tangent.y() * away.x();
    return Intersection{tangent.dot(away), tangent.x() > 0 ? -across : across, at->z()};
  }
  [[nodiscard]] Foot between(const Intersection& a,
                             const Intersection& b,
                             std::size_t i,
                             double t) const {
    const double inside = std::clamp(t, 0.0, 1.0);
    return {points_[i - 1].along_mm + t * (points_[i].along_mm - points_[i - 1].along_mm),
            a.off_mm + inside * (b.off_mm - a.off_mm),
            a.z_mm + inside * (b.z_mm - a.z_mm)};
  }

  std::vector<Point> points_;
};

/// Position on the finger from the dot's column alone.
void locate_by_column(Dot& dot, const FaceShape& shape, const SideEdges& edges) {
  const auto u = static_cast<std::size_t>(
      std::clamp(std::lround(dot.u), 0L, static_cast<long>(shape.width_px()) - 1));
  dot.along_mm = shape.length_at(dot.u);
  dot.face_px = std::max(1.0F, edges.lower[u] - edges.upper[u]);
  dot.off_face = (dot.upper ? edges.upper[u] - dot.v : dot.v - edges.lower[u]) / dot.face_px;
}

}  // namespace

void locate_on_finger(std::vector<Dot>& dots, const FaceShape& shape, const SideEdges& edges) {
  const Profile profile(shape, edges);
  const CameraParameters& camera = shape.camera().parameters();
  for (Dot& dot : dots) {
    locate_by_column(dot, shape, edges);
    const auto ray = shape.camera().unproject({dot.u, dot.v});
    if (profile.is_empty() || !ray) continue;
    const auto foot = profile.foot(*ray, dot.upper);
    if (!foot || !std::isfinite(foot->along_mm) || !std::isfinite(foot->off_mm)) continue;
    dot.along_mm = foot->along_mm;
    dot.off_face = foot->off_mm / shape.face().width_mm;
    dot.face_px = std::max(1.0, camera.fx_px * shape.face().width_mm / foot->z_mm);
  }
}

}  // namespace alltact
