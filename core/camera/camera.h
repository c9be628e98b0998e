// Camera models: 3D points in the camera frame to pixels and back.
//
// Camera frame: x along image u, y along image v, z forward, millimetres. Pixel (0, 0) is the
// centre of the top-left pixel. All pixels here are those of the picture after orientation.
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
  /// What the lens looks through, where the numbers above are its own in air; not orthographic.
  std::optional<FlatPort> port;

  bool operator==(const CameraParameters&) const = default;
};

/// A valid camera. A value: cheap to copy, no hidden state.
class Camera {
 public:
  /// Errors: size not in 16..16384, focal length not in 1..1e6 px or scale not in 1e-6..100 mm per
  /// px, principal point further than one picture size outside, wrong number of distortion
  /// coefficients for the model, or a distortion that folds over inside the picture (two rays would
  /// meet in one pixel, and none in another), a window that is none (flat_port.h). The error's
  /// `where` is the key ("camera.fx"). The dark corners of a fisheye, where a ray would be 90
  /// degrees off the axis, are no error.
  static Result<Camera> create(const CameraParameters& parameters);

  [[nodiscard]] const CameraParameters& parameters() const { return parameters_; }
  [[nodiscard]] cv::Size size() const { return {parameters_.width_px, parameters_.height_px}; }
  [[nodiscard]] bool is_perspective() const {
    return parameters_.model != CameraModel::kOrthographic;
  }
  /// True when all rays start at the camera's centre: perspective, and no window before it.
  [[nodiscard]] bool is_central() const { return is_perspective() && !parameters_.port; }
  /// True when a column of pixels is one value of x/z, and the undistortion is affine.
  [[nodiscard]] bool is_linear() const;

  /// The pixel that sees the point; nullopt when z <= 0 (perspective), not behind the window,
  /// or the ray lies beyond the angle where the distortion is one to one. The pixel may lie outside
  /// the picture.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_mm) const;

  /// The ray of a pixel, by Newton's method on the radial function bracketed by its fold
  /// (round trip < 1e-9 px); nullopt beyond the valid radius.
  [[nodiscard]] std::optional<Ray> unproject(const Eigen::Vector2d& pixel) const;

  /// Size of one pixel step along v in mm at depth z, on the optical axis: z / fy, or mm_per_px;
  /// behind a window that of the distance at which z seems to be.
  [[nodiscard]] double mm_per_px_at(double z_mm) const;
  /// Distance from z to where its rays seem to come from near the axis: z, or more behind a window.
  [[nodiscard]] double seen_from_mm(double z_mm) const;

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
                                           const Message& what,
                                           const Where& where,
                                           const Message& advice);

}  // namespace alltact
