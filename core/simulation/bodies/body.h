// Rigid bodies that press into the face.
#pragma once

#include <memory>

#include <Eigen/Geometry>

namespace alltact {

/// A body at its pose in one frame. Camera frame, mm.
class PosedBody {
 public:
  PosedBody() = default;
  PosedBody(const PosedBody&) = delete;
  PosedBody& operator=(const PosedBody&) = delete;
  virtual ~PosedBody() = default;
  /// Returns the smallest z of the body over (x, y) if it is below `below_mm`, else infinity.
  [[nodiscard]] virtual double lowest_z_mm(double x_mm, double y_mm, double below_mm) const = 0;
};

/// A body in its own coordinates, mm. Its z axis points away from the surface it presses into.
class Body {
 public:
  Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  virtual ~Body() = default;
  /// The z axis of `camera_from_object` must be less than 85 degrees off the camera's. The body
  /// must outlive the result.
  [[nodiscard]] virtual std::unique_ptr<const PosedBody> posed(
      const Eigen::Isometry3d& camera_from_object) const = 0;
  /// Returns the minimum of `direction` . p over the body's points p.
  [[nodiscard]] virtual double min_along_mm(const Eigen::Vector3d& direction) const = 0;
  /// Half lengths in x and y, about the origin, of the part that may come into contact.
  [[nodiscard]] virtual Eigen::Vector2d half_size_mm() const = 0;
  [[nodiscard]] double reach_mm() const { return half_size_mm().norm(); }
};

}  // namespace alltact
