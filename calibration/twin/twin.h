// A twin: the scene whose images match those of a real finger as closely as the images determine
// it.
//
// BACKGROUND
// Of a finger or sensor there are an untouched image and some of a pressed ball of known radius.
// The simulator renders both from a scene. Unknown parts of the scene are lamps, layer, the shape
// of the face around the ball, blur and noise. They are fitted so that simulated and real images
// agree.
//
// MODEL
// 1. The middle line of a Fin Ray finger in every image, from its edges, is that of the effects
//    bend and sway (twin_untouched.h).
// 2. Lamps: up to eight. Each is added where it reduces the remaining residual most, then all are
//    moved together to the least squares of the untouched images (twin_untouched.h).
// 3. Layer, coat, roll-off, bulge, blur, and the position, depth and light of every press: least
//    squares of block means of  I / I_ref * T_untouched - T  around the presses, in grey levels.
//    I is the pressed image, I_ref the untouched one in the same pose, T and T_untouched are the
//    simulator's. The lamps' residual errors cancel in this ratio (twin_contact.h).
// 4. Noise, from second differences: of two untouched images, of a pressed and an untouched one
//    outside the contact, or of one image.
//
// STANDARD DEVIATIONS are those of the linearised fit. Residuals count as correlated within sectors
// about each contact and independent between them (K.-Y. Liang, S. Zeger, Biometrika 73, 1986): the
// model error is smooth and would otherwise count thousands of times.
//
// NOT ESTIMATED
// Camera, layer thickness and ball radii. The layer's absorption is assumed 0: it and the
// scattering change the same curve. Twist, side faces and dots of a Fin Ray finger are not in the
// scene: only the face is compared.
#pragma once

#include "calibration/presses/press_input.h"
#include "calibration/twin/twin_scene.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/finger/finger_store.h"
#include "core/finger/press_set.h"
#include "core/sensing/face/face_shape.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A pressed image and what is known of it beforehand.
struct TwinPress {
  std::string name;
  cv::Mat grey;       ///< CV_8UC1, oriented
  cv::Mat reference;  ///< CV_32FC1: the untouched face in this pose; NaN where it is not known
  FaceShape shape;    ///< of the untouched face
  double ball_radius_mm = 0;
  Eigen::Vector3d ball_mm;  ///< the ball's centre, approximate; camera frame
  Eigen::Vector2d disc_px;  ///< its dark disc in the image, approximate
  double disc_radius_px = 0;
  std::optional<GivenDepth> given_depth = std::nullopt;
};

struct TwinInput {
  std::string name;  ///< of the finger
  CameraParameters camera;
  Face face;
  std::vector<TwinPress> presses;  ///< at least one
  /// Images of the untouched finger in one pose, CV_8UC1 and oriented, for the noise; may be empty.
  std::vector<cv::Mat> untouched;
};

/// A number of the scene and its uncertainty.
struct TwinFigure {
  std::string key;  ///< "scatter_per_mm", "lamp 2 power", "press_0 depth_mm"
  Message what;
  double value = 0;
  std::optional<double> sd;  ///< empty: it could not be estimated, and `remark` holds the reason
  Message remark;            ///< may be empty
};

/// One ring of a press.
struct TwinRing {
  double radius_px = 0;       ///< middle of the ring, from the contact's middle
  double real = 0, twin = 0;  ///< mean grey levels
  double se = 0;  ///< standard error of their difference, from the scatter within the ring
};

/// Difference between the twin's image of a press and the real one, grey levels.
struct TwinResidual {
  std::string press;
  double reach_px = 0;     ///< radius around the contact's middle
  double rms = 0;          ///< all pixels within reach_px
  double profile_rms = 0;  ///< all rings
  /// The same with the real image divided by the real untouched one and multiplied by the twin's.
  /// Errors of the lamps do not count.
  double ratio_rms = 0, ratio_profile_rms = 0;
  std::vector<TwinRing> profile;  ///< rings of 1 px
};

struct Twin {
  TwinScene scene;
  std::string yaml;  ///< the scene with its noise, to be saved
  std::vector<TwinFigure> figures;
  double untouched_rms = 0;  ///< full untouched face, grey levels, the worst of the images
  std::vector<TwinResidual> residuals;  ///< one a press
  /// sentences without full stop: what could not be estimated, and why
  std::vector<Message> remarks;
};

/// Errors: nothing of the scene can be rendered (with the simulator's reason); a camera that looks
/// through a window; a Fin Ray finger whose base is not on the left; no comparable block in any
/// press; a fit without a finite result; stopped.
[[nodiscard]] Result<Twin> fit_twin(const TwinInput& input, const Job& job);

// Noise of a real camera's images: the scene's shot and read noise and fixed pattern.

/// An image and a mask of its valid pixels.
struct NoisyImage {
  cv::Mat grey;  ///< CV_8UC1
  cv::Mat used;  ///< CV_8UC1, 0: not used
};

struct TwinNoise {
  double read_sd = 0;    ///< grey levels; 0: below the rounding to integer grey levels
  double shot_gain = 0;  ///< grey levels; 0: not distinguishable from read noise
  double prnu = 0;       ///< fraction; 0: none, or not determined
  std::optional<double> read_sd_sd, shot_gain_sd, prnu_sd;
  double sd = 0;  ///< of one image in time, at its mean brightness
  Message from;   ///< source of the estimate, a sentence without full stop
};

/// Noise is estimated from second differences along both axes, which cancel smooth content. The
/// difference of two images of the same view gives noise in time. A single image gives noise in
/// time and fixed pattern.
///   alike: images of the same view where both are used; two or more give noise in time
///   alone: images of any kind; used without two of the same view
[[nodiscard]] TwinNoise measure_noise(const std::vector<NoisyImage>& alike,
                                      const std::vector<NoisyImage>& singles,
                                      const Message& what_is_alike);

// Input of a twin: images on disk, measured as a calibration measures them.

struct TwinFiles {
  PressInput presses;  ///< empty: those stored with the finger
  /// Of the presses, overrides the finger's stored notes; radius 0: the stored one.
  PressSet press_set;
  /// Images of the untouched finger, in the pose of its presses; empty: the finger's own reference.
  std::vector<std::filesystem::path> untouched;
};

struct TwinMeasured {
  TwinInput input;
  std::vector<Message> left_out;  ///< presses that cannot be used, "press_3: why"
};

/// Reads and measures the images, and finds the balls. The finger need not be calibrated. Errors:
/// no radius is known; no press, or no usable press, with each one's reason; no untouched image;
/// images that are unreadable, coloured or of another size; those of the finger's reference;
/// stopped.
[[nodiscard]] Result<TwinMeasured> measure_for_twin(const FingerSnapshot& finger,
                                                    const TwinFiles& files, const Job& job);

}  // namespace alltact
