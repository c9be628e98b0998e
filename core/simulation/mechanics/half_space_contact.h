// A ball on a thick soft body, pushed and dragged: how the surface around it moves.
#pragma once

#include "core/result.h"

#include <Eigen/Core>

namespace alltact {

/// Background. A rigid ball (radius R) is pressed with P on the flat surface of an incompressible
/// elastic half space (modulus E, G = E / 3) and then dragged aside with Q. Friction (coefficient
/// mu) limits the traction, beyond which it slips:
///   Hertz        a^3 = 3 P R (1 - 0.25) / (4 E), d = a^2 / R, p = p0 sqrt(1 - r^2 / a^2);
///   Cattaneo and Mindlin   |Q| < mu P: it sticks within c = a (1 - |Q| / (mu P))^(1/3) and slips
///                outside, with the traction mu p less (c / a) mu p0 sqrt(1 - r^2 / c^2);
///                |Q| >= mu P: it slides, and transmits mu P.
/// The displacements are those of these tractions on a half space, inside the contact and outside.
/// With Poisson's ratio 0.5 a normal load moves no point of the surface sideways, nor a tangential
/// one any point up or down. (K. L. Johnson, Contact Mechanics, 1985: 3.42 for the normal, 3.7 and
/// 7.2 for the tangential load.) A finger's side is no half space; within a few contact radii it is
/// nearly one.
class HalfSpaceContact {
 public:
  static constexpr double kMaxContactShare = 0.7;  ///< of the ball's radius: limit of the theory

  /// Error: a number is not above 0 (tangential ones may be anything), or the ball sinks in beyond
  /// the range of Hertz' theory.
  static Result<HalfSpaceContact> create(double modulus_MPa,
                                         double radius_mm,
                                         double normal_N,
                                         const Eigen::Vector2d& tangential_N,
                                         double friction);

  [[nodiscard]] double contact_radius_mm() const { return contact_mm_; }
  [[nodiscard]] double indentation_mm() const { return contact_mm_ * contact_mm_ / radius_mm_; }
  [[nodiscard]] double stick_radius_mm() const { return stick_mm_; }  ///< 0: it slides

  /// Displacement of a surface point at `at_mm` from the contact's centre: two components in the
  /// surface, in the axes of `tangential_N`, and the third into the body.
  [[nodiscard]] Eigen::Vector3d displacement_mm(const Eigen::Vector2d& at_mm) const;

 private:
  HalfSpaceContact() = default;

  double modulus_MPa_ = 0, radius_mm_ = 0, contact_mm_ = 0, stick_mm_ = 0;
  double slip_traction_MPa_ = 0;  // mu p0
  Eigen::Vector2d direction_ = Eigen::Vector2d::Zero();
};

/// The tangential force that friction transmits: at most friction * normal.
[[nodiscard]] Eigen::Vector2d limited_by_friction(const Eigen::Vector2d& tangential_N,
                                                  double normal_N,
                                                  double friction);

}  // namespace alltact
