// The mapping in the fits: a family of curves with derivatives, without the checks of Mapping.
#pragma once

#include "calibration/presses/press.h"
#include "core/base/message.h"
#include "core/finger/mapping.h"

#include <optional>

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

/// A curve at given values, prepared for many x: d = M(x) (1 + part . p) with M(0) = 0. p is the
/// unit position, from -1 to 1 along and across the area of the face with presses. Below zero M
/// continues as a straight line, so that a bulge next to the contact counts as skin above the ball.
class CurveAt {
 public:
  /// `values`: as MappingCurve::values(); they must outlive this.
  CurveAt(CurveFamily family, double x_max, const double* values);

  [[nodiscard]] double x_max() const { return x_max_; }

  /// NaN beyond the pole of a Moebius curve. `gradient` (by the values, may be null) has numbers()
  /// entries.
  [[nodiscard]] double depth_mm(double x, const Eigen::Vector2d& unit_position,
                                double* gradient = nullptr) const;
  /// In the middle of the face.
  [[nodiscard]] double slope_mm(double x) const;

  /// The difference x at which the mapping gives a depth, and the slope there.
  struct Inverse {
    double x = 0;         ///< NaN where no x gives the depth
    double slope_mm = 0;  ///< dM/dx there
  };
  /// `near`: where the search starts. `gradient` (dx by the values, may be null) has numbers()
  /// entries.
  [[nodiscard]] Inverse inverse(double depth_mm, const Eigen::Vector2d& unit_position, double near,
                                double* gradient = nullptr) const;

 private:
  /// A Kubelka-Munk layer over black, of thickness `thickness_mm` when untouched. s is its
  /// scattering, k absorption over scattering, A = 1 + k, B^2 = k (k + 2) and t the remaining
  /// fraction of the layer: R(t) = sinh(B s t) / (A sinh(B s t) + B cosh(B s t)) and
  /// x = 1 - R(t) / R(1). Derivatives are by the values (slope at zero without absorption, s, k).
  struct AbsorbingLayer {
    double thickness_mm = 0, s = 0, a = 1, b2 = 0;
    double full = 0;  // R(1) / s
    double full_by_s = 0, full_by_k = 0;
    double zero_slope_mm = 0;  // d by x at x = 0
    Eigen::Vector3d zero_slope_by_values = Eigen::Vector3d::Zero();

    explicit AbsorbingLayer(const double* values);
    [[nodiscard]] bool is_possible() const;
    [[nodiscard]] double depth_mm(double x, double* gradient) const;
    [[nodiscard]] double slope_mm(double x) const;
    [[nodiscard]] double inverse(double depth_mm) const;
  };

  double curve(double x, double* gradient) const;
  [[nodiscard]] double polynomial_inverse(double depth, double near) const;

  CurveFamily family_;
  double x_max_;
  const double* values_;
  std::optional<AbsorbingLayer> layer_;
};

/// A curve and its values.
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

  /// At these values, or at others stored elsewhere (in a solver).
  [[nodiscard]] CurveAt at() const { return at(values_.data()); }
  [[nodiscard]] CurveAt at(const double* values) const { return {family_, x_max_, values}; }

  /// In the middle of the face; see CurveAt.
  [[nodiscard]] double depth_mm(double x, double* gradient = nullptr) const {
    return at().depth_mm(x, Eigen::Vector2d::Zero(), gradient);
  }
  [[nodiscard]] double slope_mm(double x) const { return at().slope_mm(x); }

 private:
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
