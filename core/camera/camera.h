// Camera models: 3D points in the camera frame to pixels and back.
//
// Camera frame: x along image u, y along image v, z forward, millimetres. Pixel (0, 0) is the
// centre of the top-left pixel. All pixels here are those of the oriented image.
#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

// The viewing ray of one pixel.

/// Points seen by one pixel: point(z) = origin + z * direction, with origin.z = 0 and direction.z =
/// 1. The ray of a perspective camera starts at the camera's centre, or behind a flat window at a
/// lateral offset; orthographic rays are parallel to z.
struct Ray {
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();

  [[nodiscard]] Eigen::Vector3d point_at(double z_mm) const { return origin_mm + z_mm * direction; }
};

// A flat window between lens and finger: air, a plate, then a clear medium.
//
// The window is perpendicular to the optical axis, with the camera's centre in the air before it. A
// lens calibrated in air shows objects in silicone too large: without this model their distance is
// about a quarter too small.

struct FlatPort {
  double gap_mm = 0;           ///< air between the camera's centre and the plate, 0 to 1000
  double plate_mm = 0;         ///< thickness of the plate, 0 to 1000
  double plate_index = 1.49;   ///< of refraction, 1 to 3; acrylic
  double medium_index = 1.41;  ///< of refraction, 1 to 3; silicone

  bool operator==(const FlatPort&) const = default;
};

/// Error: a number outside its range; `where` names it ("gap_mm").
[[nodiscard]] Status check_port(const FlatPort& port);

/// The ray in the medium of light that leaves the camera along `air_direction` (z > 0), in the
/// camera frame and extended backwards to z = 0. Snell's law at both surfaces, exact. nullopt when
/// the direction does not point forwards.
[[nodiscard]] std::optional<Ray> ray_through(const FlatPort& port,
                                             const Eigen::Vector3d& air_direction);

/// The direction in air (z = 1) along which the camera sees a point of the medium: the one root of
/// Snell's law, by Newton's method between bounds, to rounding. nullopt for a point not behind the
/// plate, or seen more than 89.9 degrees off the axis.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_to(const FlatPort& port,
                                                          const Eigen::Vector3d& point_mm);

/// Apparent distance in air of a point on the axis at z_mm.
[[nodiscard]] double apparent_distance_mm(const FlatPort& port, double z_mm);

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
  double fx_px = 0, fy_px = 0;  ///< focal lengths; unused when orthographic
  double cx_px = 0, cy_px = 0;  ///< principal point; the pixel at x = y = 0
  double mm_per_px = 0;         ///< orthographic only
  /// Standard deviations of fx, fy, cx and cy. Empty: unknown, not in what is measured with it.
  std::vector<double> sd_px;
  /// brown: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, as in OpenCV; fisheye: k1 k2 k3 k4; may be
  /// shorter.
  std::vector<double> distortion;
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
  /// one pixel, none in another); an invalid window. The error's `where` is the key
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
[[nodiscard]] Result<cv::Mat> oriented_for(const CameraParameters& camera, const cv::Mat& raw,
                                           const Message& what, const Where& where,
                                           const Message& advice);

// Plausibility of a camera, beyond the limits of the mathematics.

/// Check for files and typed values; Camera::create() checks the limits of the mathematics. Valid
/// are
///   a focal length of 0.05 to 10 times the image's longer side: 6 to 168 degrees of view,
///   fx and fy within a factor of 2: pixels are nearly square,
///   mm_per_px that makes the image 0.1 mm to 10 m wide.
/// Errors as of Camera::create(), which is called first; `where` is the key ("camera.fx").
[[nodiscard]] Status check_camera_range(const CameraParameters& parameters);

/// Possible but implausible values of a finger's camera: a focal length outside 0.2 to 4 times the
/// longer side (14 to 136 degrees of view), a principal point outside the middle three fifths of
/// the image. Each with its key.
[[nodiscard]] std::vector<Error> implausible_camera(const CameraParameters& parameters);

// Images of reduced resolution, each pixel the mean of several, and their camera model.

/// Converts a coordinate of the full image to the reduced one. The centre of reduced pixel 0 is the
/// mean of those of pixels 0 to by - 1.
[[nodiscard]] constexpr double reduced_px(double full_px, int by) {
  return (full_px + 0.5) / by - 0.5;
}
/// The inverse of reduced_px().
[[nodiscard]] constexpr double full_px(double reduced_px, int by) {
  return (reduced_px + 0.5) * by - 0.5;
}

/// CV_8UC1: each pixel the mean of by x by, rounded. Incomplete squares at the far ends are left
/// out. by: 1 (no copy) or more.
[[nodiscard]] cv::Mat reduced_image(const cv::Mat& grey, int by);

/// The camera of such images: the same rays, in pixels of the reduced image.
[[nodiscard]] CameraParameters reduced_camera(const CameraParameters& camera, int by);

}  // namespace alltact
