// A ball on a thin soft layer bonded to a rigid base.
#pragma once

#include "core/base/result.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Background. A rigid ball (radius R) presses without friction on a layer (thickness h, modulus E,
/// incompressible) whose far side cannot move. In linear elasticity everything follows from
/// chi = sqrt(R d) / h, with d the indentation along the normal:
///   force F = 16/9 E sqrt(R) d^1.5 f(chi),     f = 1 + 1.16 chi + ..., f(0) = 1 being Hertz,
///   contact radius a = sqrt(R d) g(chi),       from sqrt(R d) (thick) towards 1.7 of it (thin),
///   pressure p(r) = (m + 1) F / (pi a^2) (1 - r^2/a^2)^m,   m(chi) from 0.5 (Hertz) to 1.2.
/// The pressure's integral is F, and F is the derivative of energy_Nmm().
///
/// Source. f, g and m are polynomials through the numerical solution of the contact's integral
/// equation (N. N. Lebedev and Ia. S. Ufliand, Journal of Applied Mathematics and Mechanics 22,
/// 1958), within 0.15 % of F and a and 0.01 of m; m is such that p(0) is that of the solution. The
/// series in use elsewhere agree only for small chi: that of Dimitriadis et al. (Biophysical
/// Journal 82, 2002) is 5 % low at chi = 0.4 and 17 % at chi = 1, where most presses on a finger
/// are; that of Garcia and Garcia (Biophysical Journal 114, 2018) is 17 % high there.
///
/// Range. chi up to kMaxChi and d up to kMaxDepthShare of h; a real layer stiffens beyond
/// strains of about 0.3, which linear elasticity does not know.
class BondedLayerContact {
 public:
  static constexpr double kMaxChi = 3.3, kMaxDepthShare = 0.9;

  /// Error: a length or the modulus is not above 0.
  static Result<BondedLayerContact> create(double modulus_MPa, double layer_mm, double radius_mm);

  [[nodiscard]] double modulus_MPa() const { return modulus_MPa_; }
  [[nodiscard]] double layer_mm() const { return layer_mm_; }
  [[nodiscard]] double radius_mm() const { return radius_mm_; }

  /// The maximum indentation and force within the range.
  [[nodiscard]] double max_indentation_mm() const { return max_mm_; }
  [[nodiscard]] double max_force_N() const { return force_N(max_mm_); }

  // Arguments are clamped to 0 .. max_indentation_mm().
  [[nodiscard]] double force_N(double indentation_mm) const;
  [[nodiscard]] double stiffness_N_per_mm(double indentation_mm) const;  ///< dF/dd
  [[nodiscard]] double energy_Nmm(double indentation_mm) const;
  [[nodiscard]] double contact_radius_mm(double indentation_mm) const;
  [[nodiscard]] double pressure_exponent(double indentation_mm) const;  ///< m above
  /// At a distance from the contact's centre; 0 from its rim on, and without indentation.
  [[nodiscard]] double pressure_MPa(double indentation_mm, double r_mm) const;

  /// The indentation for a force. Error: the force is not from 0 to max_force_N().
  [[nodiscard]] Result<double> indentation_mm(double force_N) const;

 private:
  BondedLayerContact(double modulus_MPa, double layer_mm, double radius_mm);
  [[nodiscard]] double within(double indentation_mm) const;
  [[nodiscard]] double chi(double indentation_mm) const;

  double modulus_MPa_, layer_mm_, radius_mm_, max_mm_;
};

// The soft layer's surface around an indenting ball.

/// Depth of the surface below its undeformed position along the normal, at r = 0, step_mm, 2
/// step_mm, ... from the ball's axis. Within the contact it follows the ball (d - R + sqrt(R^2 -
/// r^2)). Beyond it, the contact's pressure on a bonded, incompressible layer gives
///   w(r) = int g(t) / sqrt(r^2 - t^2) dt - int (1 - phi(kh)) g^(k) J0(kr) dk,
/// the first term the half space's, with g the pressure's Abel transform, g^ its cosine transform
/// and phi = (sinh 2x - 2x) / (cosh 2x + 1 + 2x^2) the layer's compliance (I. N. Sneddon, Fourier
/// Transforms, 1951). A correction near the rim removes the mismatch with the ball, some hundredths
/// of d. The surface bulges (negative) beyond about one thickness from the rim, since the rubber is
/// incompressible. The profile ends where nothing visible remains.
[[nodiscard]] std::vector<float> indented_surface_mm(const BondedLayerContact& contact,
                                                     double indentation_mm, double step_mm);

// A ball on a thick soft body, pushed and dragged: how the surface around it moves.

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
  static Result<HalfSpaceContact> create(double modulus_MPa, double radius_mm, double normal_N,
                                         const Eigen::Vector2d& tangential_N, double friction);

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
                                                  double normal_N, double friction);

// Deflection of a soft half space around an indenting ball (Hertz).

/// Deflection of the surface relative to that under the ball's centre, at q = a/r in (0, 1], a the
/// radius of contact: ((2 - r^2/a^2) asin(a/r) + sqrt(r^2/a^2 - 1)) / pi, 0.5 at the rim. Far out
/// this is a difference of large numbers, so its series is used instead.
[[nodiscard]] inline double hertz_tail(double q) {
  if (q < 0.05) {
    const double q2 = q * q;
    return q * (4.0 / 3 + q2 * (2.0 / 15 + q2 * (3.0 / 70 + q2 * 5.0 / 252))) / std::numbers::pi;
  }
  const double r = 1 / q;
  return ((2 - r * r) * std::asin(q) + std::sqrt(std::max(0.0, r * r - 1))) / std::numbers::pi;
}

}  // namespace alltact
