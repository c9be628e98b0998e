// Estimates the deflection of a finger from its markers and their rest positions.
#pragma once

#include "core/sensing/contact/body_markers.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Displacement of the finger's tip, in its own section: towards its back (as a push on the contact
/// face moves it) and towards +y (as one on the upper face does), mm.
struct TipDisplacement {
  Eigen::Vector2d displacement_mm = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_mm2 = Eigen::Matrix2d::Zero();
  Eigen::Vector3d towards_back = Eigen::Vector3d::Zero();  ///< unit, camera frame, near the tip
  BeamModes modes_mm = BeamModes::Zero();                  ///< motion from rest
};

/// Finds the motion after which the markers, moved back, lie at their rest positions. The finger is
/// a beam that is clamped at its base, does not stretch, and moves in BeamModes. The current shape
/// of the face gives the curve to unbend and the distance of the markers behind the face.
/// Generalised least squares over the markers with `displacement_cov_px2`, by Gauss-Newton. q2,
/// which does not move the tip, has a prior from bodies of all stiffnesses.
/// A millimetre has the same weight in both directions, unlike in the image. The covariance holds
/// the markers' noise and an error of modes and face of 0.005 of the displacement. The stiffness
/// ratio between the directions is unknown: the result is the direction of motion, not of the
/// force. nullopt: a flat sensor, markers that are not those of `rest`, or too few for both
/// directions.
[[nodiscard]] std::optional<TipDisplacement> tip_displacement(
    const Markers& markers,
    const std::vector<Eigen::Vector2d>& rest,
    const FaceShape& shape,
    const Eigen::MatrixXd& displacement_cov_px2);

}  // namespace alltact
