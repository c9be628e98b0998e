// From brightness difference to press depth: d = M(x).
#pragma once

#include "core/base/result.h"

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

enum class MappingKind { kPolynomial = 1, kMoebius };
/// The thickness of the layer that determines brightness. M gives a depth in that direction; the
/// reported depth is along z.
enum class MappingAlong {
  kZ = 1,      ///< along z, above the view point
  kNormal,     ///< along the face's normal, from the view point
  kProjected,  ///< along z, above the view point, times the cosine of the face's incline: the same
               ///< layer without contact everywhere, however the finger bends
};
/// As files write it: "z", "normal", "projected".
[[nodiscard]] std::string_view to_string(MappingAlong along);

/// Variation of a mapping over the face, where light or layer are uneven: the depth is M(x) f with
///   f = 1 + part . p,  p = (position - middle) / half, each within -1 to 1,
/// position in mm along the face from its base and across it from its middle line. Outside the
/// calibrated area f has the value at its border.
struct FaceVariation {
  Eigen::Vector2d part = Eigen::Vector2d::Zero();  ///< along, across; the sum of magnitudes is at
                                                   ///< most 0.5
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero();
  Eigen::Vector2d half_mm = Eigen::Vector2d::Ones();  ///< > 0

  [[nodiscard]] bool is_none() const { return part.isZero(0.0); }
  [[nodiscard]] Eigen::Vector2d within(const Eigen::Vector2d& position_mm) const {
    return (position_mm - middle_mm).cwiseQuotient(half_mm).cwiseMax(-1.0).cwiseMin(1.0);
  }
  [[nodiscard]] double at(const Eigen::Vector2d& position_mm) const {
    return 1.0 + part.dot(within(position_mm));
  }
};

/// How light spreads in the layer before it comes back (core/sensing/depth/light_spread.h). Zero
/// scattering: the brightness of a pixel depends on the layer at that pixel alone.
struct LightSpread {
  /// Optical thickness of the layer: reduced scattering times thickness; 0 to kMaxOpticalThickness.
  double optical_thickness = 0, optical_thickness_sd = 0;
  /// Width of the skirt relative to that of an even layer that scatters in all directions alike.
  double width_factor = 1;
  /// b of the Moebius curve for a line of sight along the normal, > 0, and the logarithm of its
  /// change from the middle of the calibrated length to its end: the angle of the light changes.
  double b_straight = 0, log_b_along = 0;
  double middle_mm = 0, half_mm = 1;  ///< of the calibrated length along the face

  static constexpr double kMaxOpticalThickness = 4.0, kMinWidth = 0.3, kMaxWidth = 3.0;
  [[nodiscard]] bool is_local() const { return optical_thickness == 0; }
};

/// Parameters of a mapping.
///   polynomial: d = x * sum_k c_k T_k(2 x / x_max - 1), T_k Chebyshev polynomials: zero at zero by
///               construction and well conditioned on [0, x_max].
///   moebius:    d = a x / (1 + b x), a > 0, b > -1 / x_max: a Kubelka-Munk layer over a dark coat.
struct MappingParameters {
  MappingKind kind = MappingKind::kPolynomial;
  MappingAlong along = MappingAlong::kZ;
  double x_max = 0;               ///< end of the calibrated domain [0, x_max], 0 < x_max <= 1
  std::vector<double> chebyshev;  ///< polynomial: c_0 .. c_n, at most 12, mm
  double a_mm = 0, b = 0;         ///< moebius
  FaceVariation variation;
  LightSpread spread;  ///< moebius along the normal only: x is then what is left without it
  /// Of chebyshev, or of (a, b), followed by variation.part if it is set; empty when unknown.
  Eigen::MatrixXd covariance;
};

/// A valid mapping: finite and strictly increasing on its domain.
///
/// depth_mm() is defined, finite, continuous and increasing for every x, and only a NaN gives a
/// NaN:
///   x in [0, x_max]  the calibrated curve
///   x > x_max        a straight line with the curve's end slope
///   x < 0            skin that bulges towards the camera, depth < 0.
///                    moebius: the same curve, which is that of a thicker layer, down to x_min(),
///                    then a straight line with its slope there.
///                    polynomial: the tangent at 0, because a polynomial beyond its data has no
///                    physical meaning (x_min() = 0).
/// Depths stay within -4 M(x_max) and 4 M(x_max). The caller checks for extrapolation: x > x_max().
class Mapping {
 public:
  /// Errors: domain out of range, coefficients not finite or missing, not increasing, a depth of
  /// more than 1000 mm, an invalid covariance (size, symmetry, negative variance). The error's
  /// `where` is the key in a finger file ("mapping.chebyshev").
  static Result<Mapping> create(MappingParameters parameters);

  [[nodiscard]] const MappingParameters& parameters() const { return parameters_; }
  [[nodiscard]] double x_max() const { return parameters_.x_max; }
  /// End of the curve on the side of the bulge, <= 0. moebius: where 1 + b x is 1/2 (for K = 0
  /// beyond twice the thickness without contact, see `b` in MappingParameters), at least -1.
  [[nodiscard]] double x_min() const { return x_min_; }

  [[nodiscard]] double depth_mm(double x) const;
  /// dM/dx at x clamped to [x_min, x_max]; > 0.
  [[nodiscard]] double slope_mm(double x) const;
  /// Standard deviation of M(x), in the middle of the face, from the covariance; 0 where that is
  /// unknown. Outside [x_min, x_max] it is that of the straight line, without the limit.
  [[nodiscard]] double depth_sd_mm(double x) const {
    return depth_sd_mm(x, parameters_.variation.middle_mm);
  }
  /// Standard deviation of M(x) f at a position on the face, mm along and across it.
  [[nodiscard]] double depth_sd_mm(double x, const Eigen::Vector2d& position_mm) const;
  /// The x up to x_max whose depth is depth_mm, by bisection; x_max for deeper ones. A depth below
  /// 0 has x < 0, and one below -4 M(x_max) that of the limit.
  [[nodiscard]] double difference_at(double depth_mm) const;

  /// depth_mm for n values in single precision, without branches and vectorised, for the frame
  /// pipeline. Moebius: within a relative 4e-7 / (1 + min(b, 0) x_max) of the double path.
  /// Polynomial d = x g(t), t = 2 x / x_max - 1: within 3e-6 x of the sum of magnitudes of g's
  /// powers (nanometres) plus the rounding of the result. x and depth_mm may be the same array.
  void depths_mm(const float* x, float* depth_mm, int n) const;

  /// The same curve in ascending powers of x (0, p1, p2, ...), for people and other programs. Empty
  /// for a moebius, which is no polynomial.
  [[nodiscard]] std::vector<double> powers() const;

 private:
  explicit Mapping(MappingParameters parameters);
  MappingParameters parameters_;
  /// polynomial: d / x in ascending powers of t = 2 x / x_max - 1, where the loop's Horner scheme
  /// loses at most 4 digits of 16 with 12 coefficients.
  std::vector<double> centred_powers_;
  double end_depth_mm_ = 0, end_slope_mm_ = 0;
  double x_min_ = 0, start_slope_mm_ = 0;  // the slope at x_min
};

}  // namespace alltact
