// A ball whose outline somebody drew by hand, and how a ball lies on the face.
#pragma once

#include "calibration/presses/press.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A ball over the face where it is nearest, taking the face for a plane there.
struct BallOnFace {
  double depth_mm = 0;   ///< how far it is pressed in, along the normal; <= 0: it does not touch
  double radius_mm = 0;  ///< of the circle in which the untouched face meets it; 0: none
  Eigen::Vector3d middle_mm;  ///< of that circle
  Eigen::Vector3d normal;     ///< of the face, away from the camera
};
/// nullopt where the ball is not over the part of the face that is seen.
[[nodiscard]] std::optional<BallOnFace> ball_on_face(const FaceShape& shape,
                                                     const Face& face,
                                                     const Eigen::Vector3d& centre_mm,
                                                     double radius_mm);

/// The circle in which ball and untouched face meet, as the camera sees it, in even steps around.
[[nodiscard]] std::vector<Eigen::Vector2d> contact_rim_px(const Camera& camera,
                                                          const BallOnFace& contact,
                                                          int count);

/// What find_ball() would have told of a ball that a hand put at `centre_mm`. Error: it does not
/// touch the face that the press shows.
[[nodiscard]] Result<BallGuess> guess_of_placed_ball(const Press& press,
                                                     const Face& face,
                                                     const Eigen::Vector3d& centre_mm);

}  // namespace alltact
