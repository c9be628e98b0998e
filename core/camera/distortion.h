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

/// Brown's model with OpenCV's extensions (documentation of its module calib3d): a point P at the
/// radius r is seen at
///   P (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
///   + q r^2 + 2 (q.P) P + s r^2 + t r^4,
/// with q = (p2, p1), s = (s1, s3), t = (s2, s4). Where the symmetric part of its Jacobian is
/// positive definite on a disc, no two points of the disc meet.
class BrownDistortion {
 public:
  /// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, at most; missing ones are 0.
  static constexpr std::size_t kMaxCoefficients = 12;
  explicit BrownDistortion(std::span<const double> coefficients);

  /// Radius of the undistorted disc on which the map is one to one; at most kLimit. With r f(r)
  /// for the radial part and c(r) = 6 |q| r + 2 |s| r + 4 |t| r^3: where the divisor is positive,
  /// (r f)' > c and f > c. Exact without q, s and t.
  [[nodiscard]] double valid_radius() const;

  [[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& point) const;
  /// Derivative of distort() by the point.
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& point) const;
  /// nullopt when no point of the disc of that radius is distorted to `point`.
  [[nodiscard]] std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& point,
                                                         double valid_radius) const;

  static constexpr double kLimit = 1000;  ///< 89.9 degrees off the axis

 private:
  [[nodiscard]] double factor(double r2) const;        ///< f
  [[nodiscard]] double factor_slope(double r2) const;  ///< derivative of f by r^2

  std::array<double, 4> radial_, divisor_;  // ascending powers of r^2
  bool is_rational_;                        // the divisor is not 1
  Eigen::Vector2d q_, s_, t_;
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
  [[nodiscard]] double slope(double angle) const;  ///< derivative of distance()

  std::array<double, 5> radial_;  // ascending powers of the angle's square
};

}  // namespace alltact
