// Camera models: 3D points in the camera frame to pixels and back.
//
// Camera frame: x along image u, y along image v, z forward, millimetres. Pixel (0, 0) is the
// centre of the top-left pixel. All pixels here are those of the oriented image.
#pragma once

#include "core/camera/flat_port.h"
#include "core/camera/ray.h"
#include "core/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

enum class CameraModel { kPinhole = 1, kBrown, kFisheye, kOrthographic };
/// Rotation or reflection of the raw image before any other processing. Rotations are clockwise.
enum class Orientation { kNone = 1, kFlipU, kFlipV, kRotate180, kRotate90, kRotate270 };

[[nodiscard]] std::string_view to_string(CameraModel model);
[[nodiscard]] std::string_view to_string(Orientation orientation);
[[nodiscard]] std::optional<CameraModel> camera_model_from(std::string_view word);
[[nodiscard]] std::optional<Orientation> orientation_from(std::string_view word);

/// The key `camera:` of a finger file; see Camera::create for valid values.
struct CameraParameters {
  CameraModel model = CameraModel::kPinhole;
  int width_px = 0;  ///< of the oriented image
  int height_px = 0;
  double fx_px = 0, fy_px = 0;     ///< focal lengths; unused when orthographic
  double cx_px = 0, cy_px = 0;     ///< principal point; the pixel at x = y = 0
  double mm_per_px = 0;            ///< orthographic only
  std::vector<double> distortion;  ///< brown: k1 k2 p1 p2 k3; fisheye: k1 k2 k3 k4; may be shorter
  Orientation orientation = Orientation::kNone;
  /// The flat window before the lens, where the numbers above hold for air; not orthographic.
  std::optional<FlatPort> port;

  bool operator==(const CameraParameters&) const = default;
};

/// A valid camera. A value: cheap to copy, no hidden state.
class Camera {
 public:
  /// Errors: size not in 16..16384; focal length not in 1..1e6 px or scale not in 1e-6..100 mm per
  /// px; principal point further than one image size outside; wrong number of distortion
  /// coefficients for the model; a distortion that folds over inside the image (two rays meet in
  /// one pixel, none in another); an invalid window (flat_port.h). The error's `where` is the key
  /// ("camera.fx"). The dark corners of a fisheye, where a ray would be 90 degrees off the axis,
  /// are no error.
  static Result<Camera> create(const CameraParameters& parameters);

  [[nodiscard]] const CameraParameters& parameters() const { return parameters_; }
  [[nodiscard]] cv::Size size() const { return {parameters_.width_px, parameters_.height_px}; }
  [[nodiscard]] bool is_perspective() const {
    return parameters_.model != CameraModel::kOrthographic;
  }
  /// True when all rays start at the camera's centre: perspective without a window.
  [[nodiscard]] bool is_central() const { return is_perspective() && !parameters_.port; }
  /// True when a column of pixels has one value of x/z, and the undistortion is affine.
  [[nodiscard]] bool is_linear() const;

  /// The pixel that sees the point, possibly outside the image. nullopt: z <= 0 (perspective), not
  /// behind the window, or beyond the angle up to which the distortion is one to one.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_mm) const;

  /// The ray of a pixel, by Newton's method on the radial function bracketed by its fold (round
  /// trip < 1e-9 px); nullopt beyond the valid radius.
  [[nodiscard]] std::optional<Ray> unproject(const Eigen::Vector2d& pixel) const;

  /// Size of one pixel step along v in mm at depth z, on the optical axis: z / fy, or mm_per_px.
  /// Behind a window z is replaced by the apparent distance.
  [[nodiscard]] double mm_per_px_at(double z_mm) const;
  /// Distance from z to the apparent origin of its rays near the axis: z, or more behind a window.
  [[nodiscard]] double ray_origin_z_mm(double z_mm) const;

 private:
  explicit Camera(CameraParameters parameters) : parameters_(std::move(parameters)) {}
  [[nodiscard]] bool folds_in_image() const;

  CameraParameters parameters_;
  double max_radius_ =
      0;  // brown: of the undistorted normalised point; fisheye: angle off the axis
};

/// The raw image after camera.orientation (no copy for kNone).
[[nodiscard]] cv::Mat oriented(const cv::Mat& raw, Orientation orientation);

/// The raw image in the camera's orientation. Error, with `where` and `advice`: its size differs
/// from the camera's. `what` names the image in the message.
[[nodiscard]] Result<cv::Mat> oriented_for(const CameraParameters& camera,
                                           const cv::Mat& raw,
                                           const Message& what,
                                           const Where& where,
                                           const Message& advice);

}  // namespace alltact
