// Where a pressed ball hides its own far side, the dark border is the ball's outline.
//
// Seen from the camera's centre a ball of radius R at c fills a cone of half angle asin(R / |c|).
// Its horizon, the circle where sight grazes it, is visible as a border only where it lies in the
// layer: pressed deeper than the untouched face. With b the angle between sight and face, a ball
// pressed in by h (along the normal) shows 2 acos((1 - h/R) / cos b) of it, and none at all when
// 1 - h/R > cos b: a face seen steeply from above hides nothing. There brightness jumps; elsewhere
// the border is where the skin leaves the ball, and brightness fades.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A place on the horizon that lies in the layer.
struct HorizonPoint {
  Eigen::Vector3d point_mm;
  Eigen::Vector2d pixel;
  Eigen::Vector2d outward;  ///< unit, in the picture, away from the ball
  double hidden_mm;         ///< how far, along the normal, the ball juts out before what it hides
};

/// The part of a ball's horizon that hides untouched face, in even steps of `step_deg` around the
/// ball; empty for an orthographic camera, which looks straight at its face.
[[nodiscard]] std::vector<HorizonPoint> hiding_horizon(const FaceShape& shape,
                                                       const Eigen::Vector3d& centre_mm,
                                                       double radius_mm,
                                                       double step_deg);

struct TangentArc {
  std::vector<OutlinePoint> points;
  double arc_deg = 0;  ///< of the horizon around the ball; 0: none
};

/// Looks for the outline in the picture of a press whose ball is roughly known (a few pixels):
/// along the normal of each piece of the hiding horizon, the jump that explains the brightness
/// there best, to a part of a pixel. The arc counts only where jumps explain the picture clearly
/// better than a border that fades out, stand out of the noise, and form at least 20 degrees.
[[nodiscard]] TangentArc find_tangent_arc(const Press& press,
                                          const Eigen::Vector3d& centre_mm,
                                          double radius_mm);

}  // namespace alltact
