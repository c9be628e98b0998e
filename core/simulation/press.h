// What presses into the face in one frame, and how deep it goes where.
#pragma once

#include "core/simulation/row_view.h"

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// The place of a press: where on the untouched outer side (LUF), and how that lies in space.
struct PressPlace {
  double s_mm = 0, y_mm = 0;  ///< along the face from its base; across from its middle line
  double depth_mm = 0;        ///< along z, at the deepest point
  Eigen::Vector3d luf_mm;     ///< the LUF point above the deepest point
  Eigen::Vector3d normal;     ///< of the LUF there, away from the camera
  Eigen::Vector3d along;      ///< unit tangent towards the tip, in the x-z plane
  double layer_mm = 0;        ///< thickness along the normal

  [[nodiscard]] double normal_depth_mm() const { return depth_mm * normal.z(); }
};

/// A ball, and around it a surface of revolution about the axis through its centre along the
/// LUF's normal: how deep the outer side lies below the LUF (along the normal) at distance r.
struct BallPress {
  PressPlace place;
  double radius_mm = 0;
  Eigen::Vector3d centre_mm;
  /// Within this distance from the axis the face lies on the ball wherever that reaches it; 0: the
  /// face lies on the ball nowhere.
  double contact_radius_mm = 0;
  double rim_mm = 0;  ///< where the contact ends, whatever the face does there
  /// Normal depth off the ball at r = i * kStep; 0 beyond its end. Negative: bulged. Empty where
  /// the face leaves the ball as if cut.
  std::vector<float> profile_mm;
  static constexpr double kStep_mm = 0.005;

  [[nodiscard]] double profile_at(double r_mm) const;
  [[nodiscard]] double ball_profile(double r_mm) const;  ///< of the ball alone, r <= radius
  [[nodiscard]] double reach_mm() const {
    return profile_mm.empty() ? rim_mm + 3 * kStep_mm
                              : static_cast<double>(profile_mm.size()) * kStep_mm;
  }
};

/// Anything else: normal depth on a grid in the face's own coordinates (along, across), about the
/// press's place; it follows the face where that is bent.
struct ReliefPress {
  PressPlace place;
  double rotation_rad = 0;   ///< from the finger's length towards +y
  cv::Mat_<float> depth_mm;  ///< rows across, columns along, centred
  double step_mm = 0.05;

  [[nodiscard]] double reach_mm() const;
};

/// Adds nothing outside its reach; where several things press, the deeper one counts, and bulges
/// give way. `depth_mm` covers [first, last).
void press_row(const BallPress& press, const FaceRow& face, int first, int last, float* depth_mm);
void press_row(const ReliefPress& press, const FaceRow& face, int first, int last, float* depth_mm);

/// A ball that cuts the face: on it, or untouched. The rim is where it cuts the LUF.
[[nodiscard]] BallPress make_ball_press(const PressPlace& place, double radius_mm);

}  // namespace alltact
