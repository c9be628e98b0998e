// A twin: the scene whose pictures are those of a real finger, as far as they tell.
//
// BACKGROUND
// Of a finger or sensor there are an untouched picture and some of a ball of known radius that is
// pressed in. The simulator renders both from a scene. What of the scene is not known, the lamps,
// the layer, how the face leaves the ball and swells around it, blur and noise, is fitted so that
// the simulator's own pictures come out as the real ones do.
//
// MODEL
// 1. A Fin Ray finger's middle line in every picture, told by its edges, is that of effects bend
// and
//    sway (twin_pose.h).
// 2. Lamps: up to eight, each where it does most for what those before it leave, all of them then
//    moved together to the least squares of the untouched pictures (twin_lamps.h).
// 3. Layer, coat, roll-off, bulge, blur, and the place, depth and light of every press: least
// squares of
//      block means of  I / I_ref * T_untouched - T                                     grey levels
//    around the presses, I the pressed picture, I_ref the untouched one in the same pose, T and
//    T_untouched the simulator's. What the lamps cannot match drops out of this (twin_contact.h).
// 4. Noise, from second differences: of two untouched pictures, of a pressed and an untouched one
//    beside the contact, or of one picture (twin_noise.h).
//
// STANDARD DEVIATIONS are those of the linearised fit, with residuals taken as alike within sectors
// about each contact and independent between them (K.-Y. Liang, S. Zeger, Biometrika 73, 1986):
// what the model does not describe is smooth and would otherwise count thousands of times.
//
// WHAT IS NOT ESTIMATED
// Camera, layer thickness and ball radii. The layer's absorption is taken to be 0: it and the
// scattering change the same curve. Twist, side faces and dots of a Fin Ray finger are not in the
// scene: compared is the face alone.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A pressed picture and what is known of it before.
struct TwinPress {
  std::string name;
  cv::Mat grey;       ///< CV_8UC1, turned
  cv::Mat reference;  ///< CV_32FC1: the untouched face in this pose; NaN where it is not known
  FaceShape shape;    ///< of the untouched face
  double ball_radius_mm = 0;
  Eigen::Vector3d ball_mm;  ///< the ball's centre, about; camera frame
  Eigen::Vector2d disc_px;  ///< its dark disc in the picture, about
  double disc_radius_px = 0;
  std::optional<ToldDepth> told_depth = std::nullopt;
};

struct TwinInput {
  std::string name;  ///< of the finger
  CameraParameters camera;
  Face face;
  std::vector<TwinPress> presses;  ///< at least one
  /// Pictures of the untouched finger in one pose, CV_8UC1 and turned, for the noise; may be none.
  std::vector<cv::Mat> untouched;
};

/// A number of the scene, and how well the pictures tell it.
struct TwinFigure {
  std::string key;  ///< "scatter_per_mm", "lamp 2 power", "press_0 depth_mm"
  Message what;
  double value = 0;
  std::optional<double> sd;  ///< absent: none could be told, and `remark` says why
  Message remark;            ///< empty: there is nothing to say
};

/// One ring of a press.
struct TwinRing {
  double radius_px = 0;       ///< middle of the ring, from the contact's middle
  double real = 0, twin = 0;  ///< mean grey levels
  double se = 0;  ///< standard error of their difference, by its scatter within the ring
};

/// How far the twin's picture of a press is from the real one, grey levels.
struct TwinResidual {
  std::string press;
  double reach_px = 0;     ///< how far from the contact's middle
  double rms = 0;          ///< all pixels within reach_px
  double profile_rms = 0;  ///< all rings
  /// The same with the real picture over the real untouched one times the twin's untouched one:
  /// what the lamps cannot match does not count.
  double ratio_rms = 0, ratio_profile_rms = 0;
  std::vector<TwinRing> profile;  ///< rings of 1 px
};

struct Twin {
  TwinScene scene;
  std::string yaml;  ///< the scene with its noise, to be saved
  std::vector<TwinFigure> figures;
  double untouched_rms = 0;  ///< whole untouched face, grey levels, the worst of the pictures
  std::vector<TwinResidual> residuals;  ///< one a press
  std::vector<Message> remarks;  ///< sentences without full stop: what could not be told, and why
};

/// Errors: nothing of the scene can be rendered (each with the simulator's reason), a camera that
/// looks through a window, a Fin Ray finger whose base is not on the left, no block of any press
/// that can be compared, a fit that does not end anywhere finite, stopped.
[[nodiscard]] Result<Twin> fit_twin(const TwinInput& input, const Job& job);

}  // namespace alltact
