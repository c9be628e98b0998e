// Contacts: connected regions of the depth map, in millimetres. Other notions of contact: see
// finger_contact.h.
#pragma once

#include "core/sensing/depth/depth_map.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/face/face_shape.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct ContactRegion {
  Eigen::Vector3d position_mm;  ///< depth-weighted centre on the pressed face, camera frame
  Eigen::Vector2d position_px;  ///< the same in the image
  Eigen::Vector2d position_on_face_mm = {
      0, 0};  ///< the same along the face and across it (FaceShape::position_mm)
  /// Position on the face of the skin that is pressed deepest (FaceShape::position_mm), estimated
  /// from the full region. Assumes that the object is symmetric about its middle.
  Eigen::Vector2d deepest_on_face_mm = {0, 0};
  Eigen::Vector3d deepest_point_mm;
  double deepest_mm = 0;                ///< greatest depth
  std::optional<double> deepest_sd_mm;  ///< from RegionOptions::pressed; empty without it
  double area_mm2 = 0;                  ///< on the face
  double volume_mm3 = 0;                ///< displaced, along z
  int pixels = 0;
  /// Bits of DepthLimit. With kLayerLimit some pixels are at the layer's limit: deepest_mm,
  /// volume_mm3 and every depth there are lower bounds. kSteep applies to single pixels and is not
  /// set for a region.
  std::uint8_t limits = 0;
  /// Covariance of position_mm: of contact_covariance_mm2() and lens_covariance_mm2(). Empty
  /// without `pressed`.
  std::optional<Eigen::Matrix3d> position_covariance_mm2;
  /// The same along the face and across it. Without the lens, whose errors move the entire finger.
  std::optional<Eigen::Matrix2d> on_face_covariance_mm2;
  /// Principal axis on the face from the finger's length (base to tip) towards +y, in (-90, 90].
  /// Empty when the region is round, or the sd above 15 degrees.
  std::optional<double> angle_deg;
  std::optional<double> angle_sd_deg;     ///< see contact_regions()
  std::optional<Eigen::Vector3d> axis;    ///< the same as a unit vector, camera frame
  std::optional<Eigen::Vector3d> normal;  ///< of the contact-free face there, away from the camera
  /// Convex hull of the pressed pixels, mm along the face and across it (FaceShape::position_mm),
  /// corners in order; straight to a quarter of a pixel.
  std::vector<Eigen::Vector2d> polygon_mm;
};

struct RegionOptions {
  double threshold_mm = 0.1;  ///< depth from which a pixel is in contact
  double noise_mm = 0.0;      ///< sd of a pixel's depth; the threshold is at least 4 of it
  double minimum_area_mm2 = 0.25;
  double correlated_px2 = 1.0;         ///< area of pixels with common noise, by the smoothing
  bool is_light_doubtful = false;      ///< is_light_doubtful() of the frame
  double axis_beyond_noise_deg = 0.0;  ///< sd of the axis of a contact 1 mm wide, apart from noise
  double along_sd_mm = 0.0;  ///< common sd of all positions along the face, apart from noise
  /// Errors of the depth without contact at a pixel (u, v), as DepthErrorModel::untouched; empty:
  /// noise_mm everywhere.
  std::function<UntouchedSd(int, int)> untouched;
  /// Errors of a depth in mm at a pixel (u, v), as DepthErrorModel::of_depth; empty: noise_mm.
  std::function<DepthErrorTerms(int, int, double)> pressed = {};
};

/// Regions ordered by volume, largest first. Regions whose greatest depth has less than half as
/// many standard deviations as the most certain one come last: in a pose that was not recorded a
/// wide area may seem slightly indented.
///
/// A cell is in contact where its mean depth exceeds the threshold and 4 sd of contact-free skin
/// there: sd^2 = noise^2 / n + systematic^2, with n its independent pixels (one in correlated_px2).
/// A region's mean depth, weighted by 1 / sd^2, must fulfil the same, with n of its own. Its
/// greatest depth must exceed 4 of its sd without DepthErrorTerms::lateral: a lateral offset next
/// to a steep wall does not change that there is depth.
///
/// Position of the deepest skin: skin moves along z. On a face inclined by theta the middle of a
/// body, that of the volume which it displaces, differs from the skin that lies deepest below it by
/// d sin(theta) along the face, d the greatest depth. The skin's own centre, weighted with d - h (h
/// the depth at which the region ends), lies between them. By partial integration it is (sum of (d
/// - h)^2 / sum of (d - h) / 2 + h) sin(theta) from the middle.
///
/// The angle is that of the principal axis. Its sd comprises noise and axis_beyond_noise_deg, the
/// latter over the square root of the region's width (sd across its axis, mm). It excludes the
/// uncertainty of lens, mapping and light.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const DepthMap& depth,
                                                         const FaceShape& shape, const Face& face,
                                                         const RegionOptions& options);

// Geometry of a contact in 3D: its axis, the covariance of its position, its outline.

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

/// Covariance in mm^2 of a contact's position, camera frame: the face's z errs along the line of
/// sight, the depth along z, the contact's centre by `centre_mm2` on the face, along it and across.
/// Excludes lens_covariance_mm2(). nullopt off the face.
[[nodiscard]] std::optional<Eigen::Matrix3d> contact_covariance_mm2(
    const FaceShape& shape, const Eigen::Vector2d& pixel, double depth_sd_mm,
    const Eigen::Matrix2d& centre_mm2);

/// Covariance in mm^2 by the lens (CameraParameters::sd_px) of a point of the face at a pixel,
/// camera frame; 0 where it is unknown. Errors of the principal point move the point across the
/// line of sight. Those of the focal length move a finger along z, whose distance is measured by
/// its width, and a flat face from the optical axis.
[[nodiscard]] Eigen::Matrix3d lens_covariance_mm2(const FaceShape& shape,
                                                  const Eigen::Vector2d& pixel,
                                                  const Eigen::Vector3d& point_mm);

/// Convex hull, corners in order, without corners within `tolerance_mm` of the line between others.
[[nodiscard]] std::vector<Eigen::Vector2d> convex_polygon(
    const std::vector<Eigen::Vector2d>& points_mm, double tolerance_mm);

}  // namespace alltact
