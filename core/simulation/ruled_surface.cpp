#include "core/simulation/ruled_surface.h"

#include <cmath>

namespace alltact {

namespace {

constexpr double kFarthestMeeting_mm = 1e5;
constexpr int kParts = 48;  // of the curve and an eighth beyond either end, searched for a start

}  // namespace

RuledSurface RuledSurface::view_face(const FaceCurve& curve) {
  return {curve, Line::kAcross, 0};
}

RuledSurface RuledSurface::side_face(const FaceCurve& curve, int side, double width_mm) {
  return {curve, Line::kBack, side * width_mm / 2};
}

RuledSurface::Ruling RuledSurface::ruling_at(double s_mm) const {
  const FaceCurve::Node n = curve_->at(s_mm);
  const double c = std::cos(n.twist), s = std::sin(n.twist);
  const Eigen::Vector3d along(n.x_s, 0, n.z_s);
  const Eigen::Vector3d across(-s * n.z_s, c, s * n.x_s), normal(-c * n.z_s, -s, c * n.x_s);
  // The frame rotates by theta' about y and by twist' about the curve.
  const Eigen::Vector3d across_s = n.twist_s * normal - s * n.theta_s * along;
  const Eigen::Vector3d normal_s = -n.twist_s * across - c * n.theta_s * along;
  Ruling ruling;
  ruling.p = Eigen::Vector3d(n.x_mm, n.shift_mm, n.z_mm) + offset_mm_ * across;
  ruling.p_s = Eigen::Vector3d(n.x_s, n.shift_s, n.z_s) + offset_mm_ * across_s;
  const bool is_across = line_ == Line::kAcross;
  ruling.g = is_across ? across : Eigen::Vector3d(-normal);
  ruling.g_s = is_across ? across_s : Eigen::Vector3d(-normal_s);
  return ruling;
}

std::optional<RuledSurface::Intersection> RuledSurface::intersect(const Ray& ray,
                                                                  double near_s_mm) const {
  const Eigen::Vector3d& d = ray.direction;
  double s = near_s_mm;
  for (int i = 0; i < 20; ++i) {
    const Ruling ruling = ruling_at(s);
    const Eigen::Vector3d from_ray = ruling.p - ray.origin_mm, g_d = ruling.g.cross(d);
    const double slope = ruling.p_s.dot(g_d) + from_ray.dot(ruling.g_s.cross(d));
    if (std::abs(slope) < 1e-9) return std::nullopt;
    const double step = -from_ray.dot(g_d) / slope;
    s += step;
    if (!(std::abs(s) < kFarthestMeeting_mm)) return std::nullopt;
    if (std::abs(step) > kLastStep_mm) continue;
    // p - o = z d - r g at the step's end, to first order; the remainder is of second order.
    const Eigen::Vector3d g = ruling.g + step * ruling.g_s, end_g_d = g.cross(d);
    const Eigen::Vector3d end = from_ray + step * ruling.p_s;
    Intersection intersection;
    intersection.s_mm = s;
    intersection.r_mm = d.cross(end).dot(end_g_d) / end_g_d.squaredNorm();
    intersection.z_mm = g.cross(end).dot(end_g_d) / end_g_d.squaredNorm();
    intersection.point_s = ruling.p_s + intersection.r_mm * ruling.g_s;
    intersection.point_r = ruling.g;
    intersection.normal = intersection.point_s.cross(ruling.g).normalized();
    const bool grazes = std::abs(intersection.normal.dot(d)) <= kMinSlant * d.norm();
    if (intersection.z_mm <= 0 || grazes) return std::nullopt;
    return intersection;
  }
  return std::nullopt;
}

std::optional<RuledSurface::Intersection> RuledSurface::intersect(const Ray& ray) const {
  const auto volume = [&](double s) {
    const Ruling ruling = ruling_at(s);
    return (ruling.p - ray.origin_mm).dot(ruling.g.cross(ray.direction));
  };
  const double from = -curve_->length_mm() / 8;
  const double part = 1.25 * curve_->length_mm() / kParts;
  double before = volume(from);
  for (int i = 1; i <= kParts; ++i) {
    const double here = volume(from + i * part);
    if ((before < 0) != (here < 0)) {
      const double start = from + part * (i - 1 + before / (before - here));
      if (auto intersection = intersect(ray, start)) return intersection;
    }
    before = here;
  }
  return std::nullopt;
}

}  // namespace alltact
