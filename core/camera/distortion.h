// The two families of lens distortion, in normalised coordinates (x / z, y / z), and their inverse.
#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace alltact {

/// Smallest x in (0, limit) where the polynomial (ascending powers, positive at 0) reaches 0;
/// `limit` where there is none.
[[nodiscard]] double first_root(std::span<const double> powers, double limit);

/// Brown's model: P (1 + k1 r^2 + k2 r^4 + k3 r^6) + q r^2 + 2 (q.P) P, with q = (p2, p1). The map
/// is the gradient of a function of P, so its Jacobian is symmetric. Where that is positive
/// definite on a disc, no two points of the disc meet.
class BrownDistortion {
 public:
  /// k1 k2 p1 p2 k3; missing ones are 0.
  explicit BrownDistortion(std::span<const double> coefficients);

  /// Radius of the undistorted disc on which the map is one to one; at most kLimit. With r f(r)
  /// for the radial part and |q| = Q: where (r f)' > 6 Q r and f > 6 Q r. Exact without p1, p2.
  [[nodiscard]] double valid_radius() const;

  [[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& point) const;
  /// Derivative of distort() by the point.
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& point) const;
  /// nullopt when no point of the disc of that radius is distorted to `point`.
  [[nodiscard]] std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& point,
                                                         double valid_radius) const;

  static constexpr double kLimit = 1000;  ///< 89.9 degrees off the axis

 private:
  std::array<double, 4> radial_;  // ascending powers of r^2
  Eigen::Vector2d q_;
};

/// Kannala and Brandt's model: a ray at the angle t off the axis is seen at the distance
/// t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8).
class FisheyeDistortion {
 public:
  /// k1 k2 k3 k4; missing ones are 0.
  explicit FisheyeDistortion(std::span<const double> coefficients);

  /// Angle up to which the distance grows; at most kLimit.
  [[nodiscard]] double valid_angle() const;

  [[nodiscard]] double distance(double angle) const;
  [[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& point) const;
  /// Derivative of distort() by the point.
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& point) const;
  /// nullopt when the ray would lie at `valid_angle` or further off the axis.
  [[nodiscard]] std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& point,
                                                         double valid_angle) const;

  static constexpr double kLimit = 1.5707953;  ///< a little less than a right angle

 private:
  std::array<double, 5> radial_;  // ascending powers of the angle's square
};

}  // namespace alltact
