// A ball on a thin soft layer bonded to a rigid base.
#pragma once

#include "core/result.h"

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

}  // namespace alltact
