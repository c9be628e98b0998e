#include "core/sensing/contact/contact_geometry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace alltact {

std::optional<ContactPlane> contact_plane(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  const auto local = shape.at(pixel.x(), pixel.y());
  if (!local) return std::nullopt;
  // The face is nearly straight along y: its length is across y.
  const double to_tip = shape.base_at_low_u() ? 1.0 : -1.0;
  ContactPlane plane;
  plane.col(0) = to_tip * Eigen::Vector3d::UnitY().cross(local->normal).normalized();
  plane.col(1) = to_tip * local->normal.cross(plane.col(0));
  return plane;
}

std::optional<Eigen::Vector3d> contact_axis(const FaceShape& shape,
                                            const Eigen::Vector2d& pixel,
                                            double angle_deg) {
  const auto plane = contact_plane(shape, pixel);
  if (!plane) return std::nullopt;
  const double angle = angle_deg * M_PI / 180.0;
  return (*plane * Eigen::Vector2d(std::cos(angle), std::sin(angle))).normalized();
}

std::optional<Eigen::Matrix3d> contact_covariance_mm2(const FaceShape& shape,
                                                      const Eigen::Vector2d& pixel,
                                                      double depth_sd_mm) {
  const auto& columns = shape.columns();
  const auto ray = shape.camera().unproject(pixel);
  const auto u = std::lround(pixel.x());
  if (!ray || u < 0 || u >= static_cast<long>(columns.size())) return std::nullopt;
  const FaceColumn& column = columns[static_cast<std::size_t>(u)];
  if (!column.valid || !std::isfinite(depth_sd_mm)) return std::nullopt;
  const Eigen::Vector3d sight = column.z_sd_mm * ray->direction;
  Eigen::Matrix3d covariance = sight * sight.transpose();
  covariance(2, 2) += depth_sd_mm * depth_sd_mm;
  return covariance;
}

std::vector<Eigen::Vector2d> convex_polygon(const std::vector<Eigen::Vector2d>& points_mm,
                                            double tolerance_mm) {
  if (points_mm.empty()) return {};
  // Relative to one of them, so that single precision is enough.
  const Eigen::Vector2d& origin = points_mm.front();
  std::vector<cv::Point2f> points, hull, corners;
  for (const Eigen::Vector2d& point : points_mm) {
    const Eigen::Vector2f off = (point - origin).cast<float>();
    points.emplace_back(off.x(), off.y());
  }
  cv::convexHull(points, hull);
  cv::approxPolyDP(hull, corners, tolerance_mm, true);
  std::vector<Eigen::Vector2d> polygon;
  for (const cv::Point2f& corner : corners)
    polygon.push_back(origin + Eigen::Vector2f(corner.x, corner.y).cast<double>());
  return polygon;
}

}  // namespace alltact
