// Geometry of a contact in 3D: its axis, the covariance of its position, its outline.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Unit vectors tangential to the face at a pixel, camera frame: along the finger's length (base to
/// tip), and across it towards +y. nullopt off the face.
using ContactPlane = Eigen::Matrix<double, 3, 2>;
[[nodiscard]] std::optional<ContactPlane> contact_plane(const FaceShape& shape,
                                                        const Eigen::Vector2d& pixel);

/// The direction on the face at a pixel, rotated by `angle_deg` from the finger's length (base to
/// tip) towards +y: a unit vector in the camera frame. nullopt off the face.
[[nodiscard]] std::optional<Eigen::Vector3d> contact_axis(const FaceShape& shape,
                                                          const Eigen::Vector2d& pixel,
                                                          double angle_deg);

/// Covariance in mm^2 of a point of the contact face, camera frame: the face's z errs along the
/// line of sight, the depth along z. nullopt off the face.
[[nodiscard]] std::optional<Eigen::Matrix3d> contact_covariance_mm2(const FaceShape& shape,
                                                                    const Eigen::Vector2d& pixel,
                                                                    double depth_sd_mm);

/// Convex hull, corners in order, without corners within `tolerance_mm` of the line between others.
[[nodiscard]] std::vector<Eigen::Vector2d> convex_polygon(
    const std::vector<Eigen::Vector2d>& points_mm, double tolerance_mm);

}  // namespace alltact
