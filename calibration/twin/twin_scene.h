// What a twin consists of, and the scene that says it.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/simulation/layer_reflectance.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A lamp of the effect `leds`.
struct TwinLamp {
  Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
  double power = 0;  ///< grey levels of a white surface, times mm^2
  std::optional<Eigen::Vector3d> aim_mm = std::nullopt;  ///< absent: it shines to all sides
  int lobe = 1;                                          ///< of an aimed one
};

/// How a Fin Ray finger bends in one picture: effects `bend` and `sway`.
struct TwinPose {
  double q1_mm = 0, q2_mm = 0, sway_mm = 0;
};

/// One pressed picture: a ball, and what else is its own.
struct TwinBall {
  std::string press;
  double radius_mm = 0;
  double s_mm = 0, y_mm = 0, depth_mm = 0;  ///< as the effect `ball` says them
  double light = 1;                         ///< of the lamps' power in the untouched picture
  TwinPose pose;
};

enum class TwinRolloff { kHertz = 1, kSmooth };
enum class TwinHalo { kNone = 1, kGaussian, kExponential };

/// Of one twin everything that its scene says. Frame 0 is untouched, frame i shows the i-th ball.
struct TwinScene {
  std::string name, why;
  CameraParameters camera;  ///< of a scene: not turned, nothing to look through
  Face face;
  // Fin Ray: where its untouched middle line begins, see Scene::Content.
  Eigen::Vector3d base_mm = Eigen::Vector3d::Zero();
  double incline_rad = 0, length_mm = 0;
  TwinPose rest;

  LayerOptics layer{0.6, 0, 0};
  TwinRolloff rolloff = TwinRolloff::kHertz;
  double rolloff_mm = 0.5;
  TwinHalo halo = TwinHalo::kGaussian;
  double halo_share = 0.03, halo_width_mm = 1, halo_steepness = 2;
  double blur_px = 0;     ///< 0: none to be seen
  double room_level = 0;  ///< effect `ambient`; 0: none
  std::vector<TwinLamp> lamps;
  std::vector<TwinBall> balls;

  double shot_gain = 0, read_sd = 0, prnu = 0;  ///< 0: none
  /// What a line of the scene is from, by effect ("layer", "ball press_3"), as a comment beside it.
  std::map<std::string, std::string> comments;

  /// As Scene::parse reads it. Without noise frames are float and what the camera would see on
  /// average.
  [[nodiscard]] std::string to_yaml(bool with_noise) const;
  /// The same of the untouched finger, or one ball, alone: two frames, the second with the ball.
  [[nodiscard]] TwinScene with_ball(const TwinBall& ball) const;
  [[nodiscard]] TwinScene untouched(const TwinPose& pose) const;
};

}  // namespace alltact
