// The mapping as the fits see it: a family of curves with derivatives, without the checks of
// Mapping.
#pragma once

#include "core/finger/mapping.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A kind of curve and how many numbers it has.
struct CurveFamily {
  MappingKind kind = MappingKind::kMoebius;
  int coefficients = 2;  ///< 2 for Moebius
  bool varies = false;   ///< over the face (FaceVariation): two numbers more

  [[nodiscard]] int numbers() const { return coefficients + (varies ? 2 : 0); }
  [[nodiscard]] std::string name() const;  ///< "Moebius", "polynomial of degree 3"
  bool operator==(const CurveFamily&) const = default;
};

/// d = M(x) (1 + part . p) with M(0) = 0 and p the place on the face, from -1 to 1 along and across
/// it where there are presses. Below zero M goes on straight, so that a bulge next to the contact
/// counts as skin above the ball.
class MappingCurve {
 public:
  MappingCurve(CurveFamily family, double x_max)
      : family_(family), x_max_(x_max), values_(Eigen::VectorXd::Zero(family.numbers())) {}

  [[nodiscard]] const CurveFamily& family() const { return family_; }
  [[nodiscard]] double x_max() const { return x_max_; }
  /// (a, b), or the Chebyshev coefficients; and then part, if the family varies.
  [[nodiscard]] Eigen::VectorXd& values() { return values_; }
  [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }

  /// The straight line d = slope * x in this family.
  void set_line(double slope_mm) {
    values_.setZero();
    values_[0] = slope_mm;
  }

  /// In the middle of the face. NaN where a Moebius curve has passed its pole. `gradient` (by
  /// values(), may be null) has numbers() entries.
  [[nodiscard]] double depth_mm(double x, double* gradient = nullptr) const {
    return depth_mm(x, Eigen::Vector2d::Zero(), gradient);
  }
  [[nodiscard]] double depth_mm(double x,
                                const Eigen::Vector2d& place,
                                double* gradient = nullptr) const {
    return evaluate(values_.data(), x, place, gradient);
  }
  /// In the middle of the face.
  [[nodiscard]] double slope_mm(double x) const;

  /// The same for numbers that stand elsewhere (a solver's).
  [[nodiscard]] double evaluate(const double* values,
                                double x,
                                const Eigen::Vector2d& place,
                                double* gradient) const;

 private:
  double curve(const double* values, double x, double* gradient) const;

  CurveFamily family_;
  double x_max_;
  Eigen::VectorXd values_;
};

/// The curve of a stored mapping, with its variation over the face.
[[nodiscard]] MappingCurve curve_of(const MappingParameters& parameters);

}  // namespace alltact
