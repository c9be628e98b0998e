// The mapping in the fits: a family of curves with derivatives, without the checks of Mapping.
#pragma once

#include "calibration/presses/press.h"
#include "core/base/message.h"
#include "core/finger/mapping.h"

#include <Eigen/Core>

namespace alltact {

/// A kind of curve and how many numbers it has. A Moebius curve with a third number is that of a
/// Kubelka-Munk layer which absorbs besides scattering: (a, b, k), k = absorption / scattering.
/// With k = 0 it is the Moebius curve d = a x / (1 + b x).
struct CurveFamily {
  MappingKind kind = MappingKind::kMoebius;
  int coefficients = 2;  ///< 2 or 3 for Moebius
  bool varies = false;   ///< over the face (FaceVariation): two more numbers

  [[nodiscard]] int numbers() const { return coefficients + (varies ? 2 : 0); }
  [[nodiscard]] bool absorbs() const { return kind == MappingKind::kMoebius && coefficients == 3; }
  [[nodiscard]] Message name() const;  ///< "Moebius curve", "polynomial of degree 3"
  bool operator==(const CurveFamily&) const = default;
};

/// d = M(x) (1 + part . p) with M(0) = 0. p is the unit position, from -1 to 1 along and across the
/// area of the face with presses. Below zero M continues as a straight line, so that a bulge next
/// to the contact counts as skin above the ball.
class MappingCurve {
 public:
  MappingCurve(CurveFamily family, double x_max)
      : family_(family), x_max_(x_max), values_(Eigen::VectorXd::Zero(family.numbers())) {}

  [[nodiscard]] const CurveFamily& family() const { return family_; }
  [[nodiscard]] double x_max() const { return x_max_; }
  /// (a, b), (a, b, k) or the Chebyshev coefficients; then `part`, if the family varies.
  [[nodiscard]] Eigen::VectorXd& values() { return values_; }
  [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }

  /// Sets the straight line d = slope * x in this family.
  void set_line(double slope_mm) {
    values_.setZero();
    values_[0] = slope_mm;
  }

  /// In the middle of the face. NaN beyond the pole of a Moebius curve. `gradient` (by values(),
  /// may be null) has numbers() entries.
  [[nodiscard]] double depth_mm(double x, double* gradient = nullptr) const {
    return depth_mm(x, Eigen::Vector2d::Zero(), gradient);
  }
  [[nodiscard]] double depth_mm(double x, const Eigen::Vector2d& unit_position,
                                double* gradient = nullptr) const {
    return evaluate(values_.data(), x, unit_position, gradient);
  }
  /// In the middle of the face.
  [[nodiscard]] double slope_mm(double x) const { return slope(values_.data(), x); }

  /// The same for values stored elsewhere (in a solver).
  [[nodiscard]] double evaluate(const double* values, double x,
                                const Eigen::Vector2d& unit_position, double* gradient) const;

  /// The difference x at which the mapping gives a depth, and the slope there.
  struct Inverse {
    double x = 0;         ///< NaN where no x gives the depth
    double slope_mm = 0;  ///< dM/dx there
  };
  /// `near`: where the search starts. `gradient` (dx by the values, may be null) has numbers()
  /// entries.
  [[nodiscard]] Inverse inverse(const double* values, double depth_mm,
                                const Eigen::Vector2d& unit_position, double near,
                                double* gradient = nullptr) const;
  [[nodiscard]] Inverse inverse(double depth_mm, const Eigen::Vector2d& unit_position,
                                double near) const {
    return inverse(values_.data(), depth_mm, unit_position, near);
  }

 private:
  double curve(const double* values, double x, double* gradient) const;
  [[nodiscard]] double slope(const double* values, double x) const;
  [[nodiscard]] double polynomial_inverse(const double* values, double depth, double near) const;

  CurveFamily family_;
  double x_max_;
  Eigen::VectorXd values_;
};

/// A curve as finger files store it. For an absorbing layer it is a polynomial within 0.0006 mm of
/// the curve. `by_values` (may be null): derivative of the stored coefficients by the curve's
/// values.
[[nodiscard]] MappingCurve stored_form(const MappingCurve& curve,
                                       Eigen::MatrixXd* by_values = nullptr);

/// The curve of a stored mapping, with its variation over the face.
[[nodiscard]] MappingCurve curve_of(const MappingParameters& parameters);

// A fitted curve as a finger file stores it.

/// The stored form of a fitted curve; `part`: the area of the face that its variation refers to.
[[nodiscard]] MappingParameters mapping_parameters(const MappingCurve& curve, MappingAlong along,
                                                   const PressedArea& part = {});

/// Whether a fitted curve is a mapping: increasing over its entire domain.
[[nodiscard]] bool increases(const MappingCurve& curve, MappingAlong along);

}  // namespace alltact
