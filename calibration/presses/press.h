// A press: one picture of a ball of known radius pushed into the face, compared with its reference.
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

/// What calibration needs of a press: the brightness difference on the face, and the face.
struct Press {
  std::string name;  ///< picture's file name without its ending
  Difference difference;
  FaceShape shape;
  double ball_radius_mm = 0;  ///< of the ball that was pressed
  /// Where a hand put the ball's centre, camera frame; absent: find_ball() looks for it.
  std::optional<Eigen::Vector3d> ball_mm = std::nullopt;
  std::optional<ToldDepth> told_depth = std::nullopt;
  /// Height of the step of a flat punch, mm; absent: it is a ball that presses.
  std::optional<double> step_mm = std::nullopt;
};

/// A ball found in a press before anything is known of the mapping.
struct BallGuess {
  Eigen::Vector3d centre_mm;  ///< camera frame
  double contact_radius_mm;   ///< of the dark disc on the face
  double rim_arc_deg;         ///< how much of the disc's rim was seen on the face
  bool cut_by_edge;           ///< part of the disc lies off the face
  /// The disc in the picture: where the darkness has fallen to 40 %, as a circle.
  Eigen::Vector2d disc_px;
  double disc_radius_px;
  double disc_radius_mm = 0;  ///< of that disc on the face, whatever the ball's radius
};

/// Finds the dark disc of one ball by itself: off axis (an ellipse in the picture), with or without
/// a bright halo, whole or cut by an edge of the face.
/// Errors, each saying what was found and what to try: nothing dark enough; two contacts; a shape
/// that is no disc on the face; less than 60 degrees of the rim visible; a disc larger than the
/// ball; a ball radius that is not finite and positive.
[[nodiscard]] Result<BallGuess> find_ball(const Press& press, const Face& face);

}  // namespace alltact
