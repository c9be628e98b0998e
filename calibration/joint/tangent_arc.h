// Occluding contour of a pressed ball: the part of the dark border that is the ball's outline.
//
// Seen from the camera's centre a ball of radius R at c fills a cone of half angle asin(R / |c|).
// Its horizon, the circle where the line of sight grazes it, shows as a border only inside the
// layer, where it is pressed deeper than the untouched face. With b the angle between sight and
// face, a ball pressed in by h (along the normal) shows 2 acos((1 - h/R) / cos b) of it. It shows
// none when 1 - h/R > cos b: a face seen steeply from above occludes nothing. Brightness jumps at
// the horizon; elsewhere the border is where the skin leaves the ball, and brightness fades.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A point on the horizon that lies in the layer.
struct HorizonPoint {
  Eigen::Vector3d point_mm;
  Eigen::Vector2d pixel;
  Eigen::Vector2d outward;  ///< unit, in the image, away from the ball
  double hidden_mm;         ///< how far, along the normal, the ball juts out over the face it hides
};

/// The part of a ball's horizon that hides untouched face, in even steps of `step_deg` around the
/// ball. Empty for an orthographic camera, whose rays are normal to the face.
[[nodiscard]] std::vector<HorizonPoint> occluding_horizon(const FaceShape& shape,
                                                          const Eigen::Vector3d& centre_mm,
                                                          double radius_mm,
                                                          double step_deg);

struct TangentArc {
  std::vector<OutlinePoint> points;
  double arc_deg = 0;  ///< of the horizon around the ball; 0: none
};

/// Searches the outline in the image of a press whose ball is known to a few pixels. Along the
/// normal of each piece of the occluding horizon it fits the jump that explains the brightness
/// best, to a fraction of a pixel. The arc counts only where jumps explain the image clearly better
/// than a fading border, exceed the noise, and form at least 20 degrees.
[[nodiscard]] TangentArc find_tangent_arc(const Press& press,
                                          const Eigen::Vector3d& centre_mm,
                                          double radius_mm);

}  // namespace alltact
