// A ball whose outline a person drew, and the pose of a ball on the face.
#pragma once

#include "calibration/presses/press.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A ball over the nearest point of the face, with the face as a plane there.
struct BallOnFace {
  double depth_mm = 0;        ///< along the normal; <= 0: no contact
  double radius_mm = 0;       ///< of the circle in which the ball cuts the untouched face; 0: none
  Eigen::Vector3d middle_mm;  ///< of that circle
  Eigen::Vector3d normal;     ///< of the face, away from the camera
};
/// nullopt where the ball is not over the visible part of the face.
[[nodiscard]] std::optional<BallOnFace> ball_on_face(const FaceShape& shape,
                                                     const Face& face,
                                                     const Eigen::Vector3d& centre_mm,
                                                     double radius_mm);

/// The circle in which the ball cuts the untouched face, in pixels, in even steps around.
[[nodiscard]] std::vector<Eigen::Vector2d> contact_rim_px(const Camera& camera,
                                                          const BallOnFace& contact,
                                                          int count);

/// The guess for a ball that a person set at `centre_mm`, in the form of find_ball(). Error: it
/// does not touch the visible face.
[[nodiscard]] Result<BallGuess> guess_of_manual_ball(const Press& press,
                                                     const Face& face,
                                                     const Eigen::Vector3d& centre_mm);

}  // namespace alltact
