// Rigid bodies that are pressed into the face.
#pragma once

#include <memory>

#include <Eigen/Geometry>

namespace alltact {

/// A body where it is in one frame. Camera frame, mm.
class PosedBody {
 public:
  PosedBody() = default;
  PosedBody(const PosedBody&) = delete;
  PosedBody& operator=(const PosedBody&) = delete;
  virtual ~PosedBody() = default;
  /// The least z of the body over (x, y) where that is below `below_mm`; else infinity.
  [[nodiscard]] virtual double lowest_z_mm(double x_mm, double y_mm, double below_mm) const = 0;
};

/// A body in its own coordinates, mm: z points away from what it is pressed into.
class Body {
 public:
  Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  virtual ~Body() = default;
  /// `camera_from_object`: its z axis less than 85 degrees off the camera's. The body must outlive
  /// what is returned.
  [[nodiscard]] virtual std::unique_ptr<const PosedBody> posed(
      const Eigen::Isometry3d& camera_from_object) const = 0;
  /// The least of `direction` . p over its points p.
  [[nodiscard]] virtual double least_along_mm(const Eigen::Vector3d& direction) const = 0;
  /// Half lengths, in x and y about its origin, of what may touch.
  [[nodiscard]] virtual Eigen::Vector2d half_size_mm() const = 0;
  [[nodiscard]] double reach_mm() const { return half_size_mm().norm(); }
};

}  // namespace alltact
