#include "core/simulation/frame_geometry.h"
#include "core/simulation/ruled_surface.h"

#include <algorithm>

namespace alltact {

namespace {

constexpr double kStep_mm = 1e-3;  // step of the differences for a twisted face's slopes

// The layer's thickness along z over a point of a twisted face, whose normal varies across it.
double twisted_t0_mm(const FaceCurve::Node& p, double across_mm, double layer_mm) {
  const Eigen::Vector3d across = FaceCurve::across(p), along(p.x_s, 0, p.z_s);
  const Eigen::Vector3d point_s =
      along + p.shift_s * Eigen::Vector3d::UnitY() +
      across_mm * (p.twist_s * FaceCurve::normal(p) - std::sin(p.twist) * p.theta_s * along);
  return layer_mm / point_s.cross(across).normalized().z();
}

}  // namespace

FrameGeometry::BodyPoint FrameGeometry::body_point(double s_mm,
                                                   double across_mm,
                                                   double behind_mm) const {
  if (!curve_)
    return {{s_mm, across_mm, face_.plane_z_mm - behind_mm},
            Eigen::Vector3d::UnitX(),
            Eigen::Vector3d::UnitZ()};
  const FaceCurve::Node p = curve_->at(s_mm);
  const Eigen::Vector3d along(p.x_s, 0, p.z_s), middle(p.x_mm, p.shift_mm, p.z_mm);
  if (!curve_->is_twisted()) {
    const Eigen::Vector3d normal(-p.z_s, 0, p.x_s);
    return {{p.x_mm + behind_mm * p.z_s, p.shift_mm + across_mm, p.z_mm - behind_mm * p.x_s},
            along,
            normal};
  }
  const Eigen::Vector3d normal = FaceCurve::normal(p);
  return {middle + across_mm * FaceCurve::across(p) - behind_mm * normal, along, normal};
}

Eigen::Vector3d FrameGeometry::luf_point_mm(double s_mm, double across_mm) const {
  if (!curve_) return {s_mm, across_mm, face_.plane_z_mm + face_.layer_mm};
  const FaceCurve::Node p = curve_->at(s_mm);
  if (!curve_->is_twisted())
    return {p.x_mm, p.shift_mm + across_mm, p.z_mm + face_.layer_mm / p.x_s};
  const Eigen::Vector3d middle(p.x_mm, p.shift_mm, p.z_mm);
  return middle + across_mm * FaceCurve::across(p) +
         Eigen::Vector3d(0, 0, twisted_t0_mm(p, across_mm, face_.layer_mm));
}

PressPose FrameGeometry::press_pose(double s_mm, double y_mm, double depth_mm) const {
  PressPose pose;
  pose.s_mm = s_mm;
  pose.y_mm = y_mm;
  pose.depth_mm = depth_mm;
  pose.layer_mm = face_.layer_mm;
  pose.luf_mm = luf_point_mm(s_mm, y_mm);
  pose.across = Eigen::Vector3d::UnitY();
  if (!curve_) {
    pose.normal = Eigen::Vector3d::UnitZ();
    pose.along = Eigen::Vector3d::UnitX();
    return pose;
  }
  if (curve_->is_twisted()) {
    const Eigen::Vector3d by_s =
        luf_point_mm(s_mm + kStep_mm, y_mm) - luf_point_mm(s_mm - kStep_mm, y_mm);
    const Eigen::Vector3d by_y =
        luf_point_mm(s_mm, y_mm + kStep_mm) - luf_point_mm(s_mm, y_mm - kStep_mm);
    pose.normal = by_s.cross(by_y).normalized();
    pose.along = by_s.normalized();
    pose.across = pose.normal.cross(pose.along);
    return pose;
  }
  const FaceCurve::Node p = curve_->at(s_mm);
  const double sin = p.z_s, cos = p.x_s;
  // dz/dx of the LUF: the view face's slope, plus the layer's growth along z where the face bends.
  const double slope = sin / cos + face_.layer_mm * sin * p.theta_s / (cos * cos * cos);
  pose.normal = Eigen::Vector3d(-slope, 0, 1).normalized();
  pose.along = Eigen::Vector3d(1, 0, slope).normalized();
  return pose;
}

double FrameGeometry::max_thickness_mm() const {
  if (!columns_.luf.empty()) return *std::max_element(columns_.luf.begin(), columns_.luf.end());
  if (!curve_) return face_.layer_mm;
  double max_value = 0;
  for (int i = 0; i <= FaceCurve::kCells; ++i)
    for (const double across : {-face_.width_mm / 2, 0.0, face_.width_mm / 2})
      max_value =
          std::max(max_value, twisted_t0_mm(curve_->at(curve_->s_mm(i)), across, face_.layer_mm));
  return max_value;
}

}  // namespace alltact
