// How a finger gave way: from where its markers lie to where they lay at rest.
#pragma once

#include "core/sensing/contact/body_markers.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// How the finger gave way at its tip, in its own section: towards its back (as a push on the
/// contact face moves it) and towards +y (as one on the upper face does), mm.
struct TipWay {
  Eigen::Vector2d way_mm = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_mm2 = Eigen::Matrix2d::Zero();
  Eigen::Vector3d towards_back = Eigen::Vector3d::Zero();  ///< unit, camera frame, near the tip
  BeamModes modes_mm = BeamModes::Zero();                  ///< that moved it from rest
};

/// Takes back what moved the finger until its markers lie where they rest. The finger is a beam
/// that is held at its base and does not stretch, and moves in BeamModes. The face's shape now
/// tells the curve that is unbent, and how far behind the face the dots stand. Generalised least
/// squares over the markers with `ways_px2`, Gauss and Newton; q2, which does not move the tip,
/// within what bodies of all stiffnesses have of it. Through all of this a millimetre counts the
/// same in both ways, which it does not in the picture. The covariance holds the markers' noise
/// and, 0.005 of the way, what modes and face leave. How much stiffer the finger is to one side is
/// not known: this is the way it moved, not the force's. nullopt: a flat sensor, markers that are
/// not those of `rest`, or ones too few to tell both.
[[nodiscard]] std::optional<TipWay> tip_way(const Markers& markers,
                                            const std::vector<Eigen::Vector2d>& rest,
                                            const FaceShape& shape,
                                            const Eigen::MatrixXd& ways_px2);

}  // namespace alltact
