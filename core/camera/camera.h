// Camera models: 3D points in the camera frame to pixels and back.
//
// Camera frame: x along image u, y along image v, z forward, millimetres. Pixel (0, 0) is the
// centre of the top-left pixel. All pixels here are those of the picture after orientation.
#pragma once

#include "core/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

enum class CameraModel { kPinhole = 1, kBrown, kFisheye, kOrthographic };
/// How the raw picture is turned before anything else looks at it. Rotations are clockwise.
enum class Orientation { kNone = 1, kFlipU, kFlipV, kRotate180, kRotate90, kRotate270 };

[[nodiscard]] std::string_view to_string(CameraModel model);
[[nodiscard]] std::string_view to_string(Orientation orientation);
[[nodiscard]] std::optional<CameraModel> camera_model_from(std::string_view word);
[[nodiscard]] std::optional<Orientation> orientation_from(std::string_view word);

/// What stands under `camera:` in a finger file; see Camera::create for what is allowed.
struct CameraParameters {
  CameraModel model = CameraModel::kPinhole;
  int width_px = 0;  ///< of the picture after orientation
  int height_px = 0;
  double fx_px = 0, fy_px = 0;     ///< focal lengths; unused when orthographic
  double cx_px = 0, cy_px = 0;     ///< principal point; the pixel at x = y = 0
  double mm_per_px = 0;            ///< orthographic only
  std::vector<double> distortion;  ///< brown: k1 k2 p1 p2 k3; fisheye: k1 k2 k3 k4; may be shorter
  Orientation orientation = Orientation::kNone;

  bool operator==(const CameraParameters&) const = default;
};

/// Points seen by one pixel: point(z) = origin + z * direction, with origin.z = 0 and
/// direction.z = 1. A perspective ray starts at the origin; orthographic rays are parallel to z.
struct Ray {
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();

  [[nodiscard]] Eigen::Vector3d point_at(double z_mm) const { return origin_mm + z_mm * direction; }
};

/// A valid camera. A value: cheap to copy, no hidden state.
class Camera {
 public:
  /// Errors: size not in 16..16384, focal length not in 1..1e6 px or scale not in 1e-6..100 mm per
  /// px, principal point further than one picture size outside, wrong number of distortion
  /// coefficients for the model, or a distortion that folds over inside the picture (two rays would
  /// meet in one pixel, and none in another). The error's `where` is the key ("camera.fx"). The
  /// dark corners of a fisheye, where a ray would be 90 degrees off the axis, are no error.
  static Result<Camera> create(const CameraParameters& parameters);

  [[nodiscard]] const CameraParameters& parameters() const { return parameters_; }
  [[nodiscard]] cv::Size size() const { return {parameters_.width_px, parameters_.height_px}; }
  [[nodiscard]] bool is_perspective() const {
    return parameters_.model != CameraModel::kOrthographic;
  }
  /// True when a column of pixels is one value of x/z, and the undistortion is affine.
  [[nodiscard]] bool is_linear() const;

  /// The pixel that sees the point; nullopt when z <= 0 (perspective) or the ray lies beyond the
  /// angle where the distortion is one to one. The pixel may lie outside the picture.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_mm) const;

  /// The ray of a pixel, by Newton's method on the radial function bracketed by its fold
  /// (round trip < 1e-9 px); nullopt beyond the valid radius.
  [[nodiscard]] std::optional<Ray> unproject(const Eigen::Vector2d& pixel) const;

  /// Size of one pixel step along v in mm at depth z, on the optical axis: z / fy, or mm_per_px.
  [[nodiscard]] double mm_per_px_at(double z_mm) const;

 private:
  explicit Camera(CameraParameters parameters) : parameters_(std::move(parameters)) {}
  [[nodiscard]] bool folds_in_picture() const;

  CameraParameters parameters_;
  double max_radius_ =
      0;  // brown: of the undistorted normalised point; fisheye: angle off the axis
};

/// Turns the raw picture as camera.orientation says (no copy for kNone).
[[nodiscard]] cv::Mat oriented(const cv::Mat& raw, Orientation orientation);

/// The raw picture turned as the camera's pictures are. Error, with `where` and `advice`: it does
/// not then have the size that the camera gives. `what` names it: "the picture".
[[nodiscard]] Result<cv::Mat> oriented_for(const CameraParameters& camera,
                                           const cv::Mat& raw,
                                           std::string_view what,
                                           const std::string& where,
                                           std::string_view advice);

}  // namespace alltact
