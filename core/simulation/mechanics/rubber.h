// Stiffness of a rubber from its durometer reading.
#pragma once

#include "core/base/result.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Durometer readings within the relation's range.
inline constexpr double kSoftestShoreA = 1, kHardestShoreA = 90;

/// Young's modulus in MPa (N/mm^2) of a rubber of hardness Shore A:
///   E = 0.0981 (56 + 7.66 S) / (0.137505 (254 - 2.54 S))
/// (A. N. Gent, "On the relation between indentation hardness and Young's modulus", Rubber
/// Chemistry and Technology 31, 1958, with the durometer's spring and pin put in). 40 gives 1.70,
/// 5 gives 0.28. Real castings differ by a tenth or more. Error: outside the readings above.
[[nodiscard]] Result<double> modulus_from_shore_a(double shore_a);

/// Of an incompressible rubber: E / 3.
[[nodiscard]] constexpr double shear_modulus(double modulus_MPa) { return modulus_MPa / 3; }

// Viscoelastic response of rubber: damping and creep.

/// A spring and a damper in parallel: under a steady load it approaches `share` of the elastic
/// deflection, as 1 - exp(-t / time_s).
struct KelvinUnit {
  double share = 0, time_s = 0;  ///< both above 0
};

/// A spring (`instant`, 1 or 0) and Kelvin-Voigt units in series. A steady unit load from t = 0 on
/// gives, in units of the elastic deflection, the creep compliance
///   j(t) = instant + sum share (1 - exp(-t / time_s)).
/// Instant 1 and one unit: the standard linear solid. Instant 0 and a unit of share 1: a damped
/// elastic body. Several units of growing times: slow creep, linear in log t, as rubbers show
/// (J. D. Ferry, Viscoelastic Properties of Polymers, 1980, ch. 1 and 3).
class KelvinChain {
 public:
  KelvinChain() = default;
  KelvinChain(double instant, std::vector<KelvinUnit> units)
      : instant_(instant), units_(std::move(units)) {}

  /// False: deflections follow from the current loads alone.
  [[nodiscard]] bool has_memory() const { return !units_.empty(); }
  [[nodiscard]] double compliance(double time_s) const;
  /// Older loads count for less than rounding: 40 of the longest time constants.
  [[nodiscard]] double memory_s() const;

  /// The deflection q(t), the integral of j(t - t') dX/dt' with X(t) the deflection of an elastic
  /// body under the loads at t. Computed step by step, exact for X linear in each step. Starts
  /// without any load.
  class History {
   public:
    explicit History(const KelvinChain& chain)
        : chain_(&chain), units_(chain.units_.size(), Eigen::Vector4d::Zero()) {}
    /// q after a step of `step_s` is before(step_s) + weight(step_s) X(t); a step of 0 is a load
    /// applied at once.
    [[nodiscard]] Eigen::Vector4d before(double step_s) const;
    [[nodiscard]] double weight(double step_s) const;
    /// Performs the step, with X at its end.
    void step(double step_s, const Eigen::Vector4d& elastic);

   private:
    const KelvinChain* chain_;
    std::vector<Eigen::Vector4d> units_;
    Eigen::Vector4d elastic_ = Eigen::Vector4d::Zero();
  };

 private:
  double instant_ = 1;
  std::vector<KelvinUnit> units_;
};

}  // namespace alltact
