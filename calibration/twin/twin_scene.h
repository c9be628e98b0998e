// The parameters of a twin, and its scene.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/simulation/illumination.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A lamp of the effect `leds`.
struct TwinLamp {
  Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
  double power = 0;  ///< grey levels of a white surface, times mm^2
  std::optional<Eigen::Vector3d> aim_mm = std::nullopt;  ///< empty: it shines to all sides
  int lobe = 1;                                          ///< of an aimed one
};

/// Bend of a Fin Ray finger in one image: effects `bend` and `sway`.
struct TwinPose {
  double q1_mm = 0, q2_mm = 0, sway_mm = 0;
};

/// One pressed image: a ball and its own parameters.
struct TwinBall {
  std::string press;
  double radius_mm = 0;
  double s_mm = 0, y_mm = 0, depth_mm = 0;  ///< as in the effect `ball`
  double light = 1;                         ///< of the lamps' power in the untouched image
  TwinPose pose;
};

enum class TwinRolloff { kHertz = 1, kSmooth };
enum class TwinHalo { kNone = 1, kGaussian, kExponential };

/// Everything that a twin's scene holds. Frame 0 is untouched, frame i shows the i-th ball.
struct TwinScene {
  std::string name, why;
  CameraParameters camera;  ///< of a scene: not rotated, without a window
  Face face;
  // Fin Ray: start of its untouched middle line, see Scene.
  Eigen::Vector3d base_mm = Eigen::Vector3d::Zero();
  double incline_rad = 0, length_mm = 0;
  TwinPose rest;

  LayerOptics layer{0.6, 0, 0};
  TwinRolloff rolloff = TwinRolloff::kHertz;
  double rolloff_mm = 0.5;
  TwinHalo halo = TwinHalo::kGaussian;
  double halo_share = 0.03, halo_width_mm = 1, halo_steepness = 2;
  double blur_px = 0;     ///< 0: not visible
  double room_level = 0;  ///< effect `ambient`; 0: none
  std::vector<TwinLamp> lamps;
  std::vector<TwinBall> balls;

  double shot_gain = 0, read_sd = 0, prnu = 0;  ///< 0: none
  /// Source of a line of the scene, by effect ("layer", "ball press_3"), as a comment at its end.
  std::map<std::string, std::string> comments;

  /// The text for Scene::parse. Without noise frames are float, the camera's expected values.
  [[nodiscard]] std::string to_yaml(bool with_noise) const;
  /// Two frames, the first of the untouched finger, the second with this ball only.
  [[nodiscard]] TwinScene with_ball(const TwinBall& ball) const;
  [[nodiscard]] TwinScene untouched(const TwinPose& pose) const;
};

// Rendered images of a twin. All of them come from here.

/// Frame `frame` without noise, CV_32FC1. Errors: those of Scene::parse and Plan::compile.
[[nodiscard]] Result<cv::Mat> twin_image(const TwinScene& scene, int frame);

/// The camera that sees a part of another's image.
[[nodiscard]] CameraParameters cropped_camera(const CameraParameters& camera, const cv::Rect& part);
/// The camera whose pixels are means over complete blocks of `side` x `side` pixels of another's.
[[nodiscard]] CameraParameters downsampled_camera(const CameraParameters& camera, int side);
/// Those means of a CV_32FC1 image; NaN where any of the pixels is NaN.
[[nodiscard]] cv::Mat downsampled_image(const cv::Mat& grey, int side);

}  // namespace alltact
