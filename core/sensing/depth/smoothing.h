// How images are smoothed before depth is measured in them.
//
// A mean over a neighbourhood of variance s^2 makes a ball of radius R shallower by s^2 / R, pixels
// squared in mm. Lens and layer, which blur as well, have the same effect. The variance of the
// depth kernel along an axis is therefore negative: minus the variance of the optics. The kernel is
// a Gaussian times (a + b k^2), a kernel of higher order (T. Gasser, H.-G. Mueller, V. Mammitzsch,
// Kernels for nonparametric curve estimation, 1985). Fits of balls model the blur and use the plain
// Gaussian, which reaches less far where the skin bends sharply.
#pragma once

#include <vector>

namespace alltact {

/// Variance of the blur of lens, pixel and layer along an axis, in a sharp image.
inline constexpr double kOpticsPx2 = 0.5;

struct Smoothing {
  /// Weights of a pixel and of those before and behind it along an axis; the sum over both sides is
  /// 1. Outer ones are negative.
  std::vector<double> weights{1.0};
  double variance_px2 = 0;  ///< sum of weight times distance squared

  /// Standard deviation of white noise after smoothing, relative to that before.
  [[nodiscard]] double noise_factor() const;
  /// Variance along an axis of all blur before depth is measured.
  [[nodiscard]] double blur_px2() const { return kOpticsPx2 + variance_px2; }
};

/// smoothing_px: leaves about as much noise as a Gaussian of that standard deviation; 0: none.
[[nodiscard]] Smoothing smoothing_of(double smoothing_px);
/// The plain Gaussian.
[[nodiscard]] Smoothing gaussian_smoothing(double smoothing_px);

}  // namespace alltact
