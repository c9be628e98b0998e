// Objects that press into the face in one frame, and their depth over it.
#pragma once

#include "core/simulation/row_view.h"
#include "core/simulation/simulated_frame.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace alltact {

// Rigid bodies that press into the face.

/// A body at its pose in one frame, camera frame: the smallest z of the body over (x, y) if it is
/// below `below_mm`, else infinity.
using PosedBody = std::function<double(double x_mm, double y_mm, double below_mm)>;

/// A body in its own coordinates, mm. Its z axis points away from the surface it presses into.
class Body {
 public:
  Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  virtual ~Body() = default;
  /// The z axis of `camera_from_object` must be less than 85 degrees off the camera's. The body
  /// must outlive the result.
  [[nodiscard]] virtual PosedBody posed(const Eigen::Isometry3d& camera_from_object) const = 0;
  /// Returns the minimum of `direction` . p over the body's points p.
  [[nodiscard]] virtual double min_along_mm(const Eigen::Vector3d& direction) const = 0;
  /// Half lengths in x and y, about the origin, of the part that may come into contact.
  [[nodiscard]] virtual Eigen::Vector2d half_size_mm() const = 0;
  [[nodiscard]] double reach_mm() const { return half_size_mm().norm(); }
};

/// The pose of a press: its position on the undeformed outer side (LUF), and the axes there.
struct PressPose {
  double s_mm = 0, y_mm = 0;  ///< along the face from its base; across from its middle line
  double depth_mm = 0;        ///< along z, at the deepest point
  Eigen::Vector3d luf_mm;     ///< the LUF point above the deepest point
  Eigen::Vector3d normal;     ///< of the LUF there, away from the camera
  Eigen::Vector3d along;      ///< unit tangent towards the tip
  Eigen::Vector3d across;     ///< normal x along: unit tangent towards +y
  double layer_mm = 0;        ///< thickness along the normal
  std::size_t contact = 0;    ///< index in FrameGeometry::contacts

  [[nodiscard]] double normal_depth_mm() const { return depth_mm * normal.z(); }
};

/// A ball, surrounded by a surface of revolution about the axis through its centre along the LUF's
/// normal. The profile is the depth of the outer side below the LUF (along the normal) at distance
/// r.
struct BallPress {
  PressPose pose;
  double radius_mm = 0;
  Eigen::Vector3d centre_mm;
  /// Within this distance from the axis the face follows the ball wherever that reaches it; 0:
  /// nowhere.
  double contact_radius_mm = 0;
  double rim_mm = 0;  ///< where the contact ends, whatever the face does there
  /// Normal depth off the ball at r = i * kStep_mm; 0 beyond its end. Negative: bulged. Empty where
  /// the face leaves the ball abruptly.
  std::vector<float> profile_mm;
  static constexpr double kStep_mm = 0.005;

  [[nodiscard]] double profile_at(double r_mm) const;
  [[nodiscard]] double ball_profile(double r_mm) const;  ///< of the ball alone, r <= radius
  [[nodiscard]] double reach_mm() const {
    return profile_mm.empty() ? rim_mm + 3 * kStep_mm
                              : static_cast<double>(profile_mm.size()) * kStep_mm;
  }
};

/// A rigid body: the outer side follows it wherever it would be below it, and is undeformed
/// elsewhere.
struct BodyPress {
  PressPose pose;
  std::shared_ptr<const Body> body;
  Eigen::Isometry3d camera_from_object;
  double rotation_rad = 0;  ///< of the object about the normal, from along towards across
  PosedBody posed;

  [[nodiscard]] double reach_mm() const;
};

/// The outer side where it does not follow the body sharply: depth along z on a grid of face
/// positions, centred on the press.
struct SampledPress {
  PressPose pose;
  double rotation_rad = 0;   ///< of the grid's columns, from along towards across
  cv::Mat_<float> depth_mm;  ///< rows across, columns along, centred
  double step_mm = 0.05;
  cv::Mat_<std::uint8_t> in_contact;  ///< 255 where the body itself would press, the grid's size

  [[nodiscard]] double reach_mm() const;
};

/// Adds nothing outside the press's reach. Where several presses overlap the larger depth wins, and
/// depth wins over bulges. `depth_mm` covers [first, last).
void press_row(const BallPress& press, const FaceRow& face, int first, int last, float* depth_mm);
void press_row(const BodyPress& press, const FaceRow& face, int first, int last, float* depth_mm);
void press_row(const SampledPress& press, const FaceRow& face, int first, int last,
               float* depth_mm);

/// True: at column `u` the face follows the pressing object, or would if it were less stiff.
[[nodiscard]] bool is_in_contact(const BallPress& press, const FaceRow& face, int u);
[[nodiscard]] bool is_in_contact(const BodyPress& press, const FaceRow& face, int u);
[[nodiscard]] bool is_in_contact(const SampledPress& press, const FaceRow& face, int u);

/// The part of a contact's truth that does not depend on the pressing object: position, depth and
/// direction.
[[nodiscard]] ContactTruth contact_truth(const PressPose& pose);

/// A ball that cuts the face: the face follows it or is undeformed. The rim is where it cuts the
/// LUF.
[[nodiscard]] BallPress make_ball_press(const PressPose& pose, double radius_mm);

// A body described by its underside.

/// All points above the underside. Its lowest points lie at z = 0.
class HeightField final : public Body {
 public:
  static constexpr double kNothing_mm = std::numeric_limits<double>::infinity();

  /// gap_mm(x, y): height of the underside over (x, y), 0 or more; kNothing_mm where there is none.
  /// finest_mm: detail thinner than this may be missed when it is viewed at a slant.
  HeightField(std::function<double(double x_mm, double y_mm)> gap_mm,
              const Eigen::Vector2d& half_size_mm, double finest_mm = 0.02)
      : gap_mm_(std::move(gap_mm)), half_size_mm_(half_size_mm), finest_mm_(finest_mm) {}

  [[nodiscard]] double gap_mm(double x_mm, double y_mm) const { return gap_mm_(x_mm, y_mm); }
  [[nodiscard]] double finest_mm() const { return finest_mm_; }
  [[nodiscard]] PosedBody posed(const Eigen::Isometry3d& camera_from_object) const override;
  /// For a tilted body on a grid of 256 steps a side; exact for an upright one.
  [[nodiscard]] double min_along_mm(const Eigen::Vector3d& direction) const override;
  [[nodiscard]] Eigen::Vector2d half_size_mm() const override { return half_size_mm_; }

 private:
  std::function<double(double x_mm, double y_mm)> gap_mm_;
  Eigen::Vector2d half_size_mm_;
  double finest_mm_;
};

}  // namespace alltact
