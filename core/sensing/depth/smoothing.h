// How pictures are smoothed before depth is read from them.
//
// A mean over a neighbourhood of variance s^2 reads a ball of radius R shallower by s^2 / R, pixels
// squared in mm; so do lens and layer, which spread light as well. Where depth is measured the
// kernel's own variance along an axis is therefore not positive but minus what optics add: it is a
// Gaussian times (a + b k^2), as kernels of higher order are made (T. Gasser, H.-G. Mueller, V.
// Mammitzsch, Kernels for nonparametric curve estimation, 1985). Fits of balls, which know what
// blur does to a ball, take the plain Gaussian: it reaches less far where the skin bends sharply.
#pragma once

#include <vector>

namespace alltact {

/// Variance of what lens, pixel and layer spread light by, along an axis: a sharp picture's.
inline constexpr double kOpticsPx2 = 0.5;

struct Smoothing {
  /// Of a pixel, and of each of those before and behind it along an axis; the sum over both sides
  /// is 1. Outer ones are negative.
  std::vector<double> weights{1.0};
  double variance_px2 = 0;  ///< sum of weight times distance squared

  /// What is left of a picture's white noise, as a part of its standard deviation.
  [[nodiscard]] double noise_part() const;
  /// Variance along an axis of all that spreads light before depth is read.
  [[nodiscard]] double blur_px2() const { return kOpticsPx2 + variance_px2; }
};

/// smoothing_px: leaves about as much noise as a Gaussian of that standard deviation; 0: none.
[[nodiscard]] Smoothing smoothing_of(double smoothing_px);
/// The Gaussian itself.
[[nodiscard]] Smoothing plain_smoothing_of(double smoothing_px);

}  // namespace alltact
