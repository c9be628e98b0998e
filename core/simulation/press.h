// What presses into the face in one frame, and how deep it goes where.
#pragma once

#include "core/simulation/bodies/body.h"
#include "core/simulation/contact_truth.h"
#include "core/simulation/row_view.h"

#include <cstdint>
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
  Eigen::Vector3d along;      ///< unit tangent towards the tip
  Eigen::Vector3d across;     ///< normal x along: unit tangent towards +y
  double layer_mm = 0;        ///< thickness along the normal
  std::size_t contact = 0;    ///< its number in FrameGeometry::contacts

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

/// A rigid body that keeps its shape whatever the face's is: the outer side lies on it wherever it
/// would be below it, and is untouched beside it.
struct BodyPress {
  PressPlace place;
  std::shared_ptr<const Body> body;
  Eigen::Isometry3d camera_from_object;
  double rotation_rad = 0;  ///< of the object about the normal, from along towards across
  std::shared_ptr<const PosedBody> posed;

  [[nodiscard]] double reach_mm() const;
};

/// How the outer side lies where it does not follow the body sharply: depth along z on a grid of
/// places of the face, about the press's place.
struct SampledPress {
  PressPlace place;
  double rotation_rad = 0;   ///< of the grid's columns, from along towards across
  cv::Mat_<float> depth_mm;  ///< rows across, columns along, centred
  double step_mm = 0.05;
  cv::Mat_<std::uint8_t> touched;  ///< 255 where the body itself would press, the grid's size

  [[nodiscard]] double reach_mm() const;
};

/// Adds nothing outside its reach; where several things press, the deeper one counts, and bulges
/// give way. `depth_mm` covers [first, last).
void press_row(const BallPress& press, const FaceRow& face, int first, int last, float* depth_mm);
void press_row(const BodyPress& press, const FaceRow& face, int first, int last, float* depth_mm);
void press_row(
    const SampledPress& press, const FaceRow& face, int first, int last, float* depth_mm);

/// True: the face lies on what presses in this point of column `u`, or would if it were not softer
/// than that.
[[nodiscard]] bool touches(const BallPress& press, const FaceRow& face, int u);
[[nodiscard]] bool touches(const BodyPress& press, const FaceRow& face, int u);
[[nodiscard]] bool touches(const SampledPress& press, const FaceRow& face, int u);

/// What is known of a contact without knowing what presses: its place, depth and direction.
[[nodiscard]] ContactTruth contact_truth(const PressPlace& place);

/// A ball that cuts the face: on it, or untouched. The rim is where it cuts the LUF.
[[nodiscard]] BallPress make_ball_press(const PressPlace& place, double radius_mm);

}  // namespace alltact
