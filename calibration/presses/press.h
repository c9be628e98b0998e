// A press: one image of a ball of known radius pushed into the face, compared with its reference.
#pragma once

#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "core/result.h"
#include "core/sensing/depth/local_depth.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Input of the calibration from one press: the brightness difference on the face, and the face.
struct Press {
  std::string name;  ///< file name of the image without its ending
  Difference difference;
  FaceShape shape;
  double ball_radius_mm = 0;  ///< of the pressed ball
  /// The ball's centre as a person set it, camera frame; empty: find_ball() searches it.
  std::optional<Eigen::Vector3d> ball_mm = std::nullopt;
  std::optional<GivenDepth> given_depth = std::nullopt;
  /// Height of the step of a flat punch, mm; empty: a ball presses.
  std::optional<double> step_mm = std::nullopt;
};

/// A ball found in a press before the mapping is known.
struct BallGuess {
  Eigen::Vector3d centre_mm;  ///< camera frame
  double contact_radius_mm;   ///< of the dark disc on the face
  double rim_arc_deg;         ///< visible arc of the disc's rim on the face
  bool cut_by_edge;           ///< part of the disc lies off the face
  /// The disc in the image: the 40 % contour of the darkness, as a circle.
  Eigen::Vector2d disc_px;
  double disc_radius_px;
  double disc_radius_mm = 0;  ///< of that disc on the face, independent of the ball's radius
};

/// Finds the dark disc of one ball without a start: off axis (an ellipse in the image), with or
/// without a bright halo, complete or cut by an edge of the face. Errors, each with what was found
/// and what to try: nothing dark enough; two contacts; a shape that is no disc on the face; less
/// than 60 degrees of the rim visible; a disc larger than the ball; a ball radius that is not
/// finite and positive.
[[nodiscard]] Result<BallGuess> find_ball(const Press& press, const Face& face);

}  // namespace alltact
