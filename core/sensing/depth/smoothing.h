// How images are smoothed before depth is measured in them.
//
// A mean over a neighbourhood of variance s^2 makes a ball of radius R shallower by s^2 / R, pixels
// squared in mm. Lens and layer, which blur as well, have the same effect. The variance of the
// depth kernel along an axis is therefore negative: minus the variance of the optics. The kernel is
// a Gaussian times (a + b k^2), a kernel of higher order (T. Gasser, H.-G. Mueller, V. Mammitzsch,
// Kernels for nonparametric curve estimation, 1985). Fits of balls model the blur and use the plain
// Gaussian, which reaches less far where the skin bends sharply.
#pragma once

#include "core/sensing/face/face_pixels.h"

#include <cstddef>
#include <cstdint>
#include <span>
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

// Row by row smoothing of an image of which only a part is given.

/// Smooths along both axes and stores only the rows that the kernel spans. Missing pixels count as
/// 0: the result is a sum over the given pixels, not a mean. Outer weights are rounded to 2^-9; the
/// middle one makes their sum 1. Grey levels are in steps (image_warp.h) and lie within 0 to 250
/// levels.
class RowSmoother {
 public:
  RowSmoother(const Smoothing& smoothing, int width);

  /// Rows below a row that its smoothing requires.
  [[nodiscard]] int radius() const { return radius_; }

  /// Buffer of a row, 0 outside of the face's runs, in which the caller writes every pixel. All
  /// rows must be requested in order.
  std::int16_t* begin_row(int number, std::span<const FaceRun> runs);

  /// A run of row `number` before smoothing.
  const std::int16_t* raw(int number, const FaceRun& run) { return line(number) + run.first; }

  /// A run of row `number` smoothed; valid until the next call. All rows up to `radius` below it
  /// must have been given.
  const std::int16_t* smoothed(int number, const FaceRun& run);

 private:
  /// Also valid for rows before the first.
  [[nodiscard]] std::size_t slot(int number) const {
    return static_cast<std::size_t>(number) & (slots_ - 1);
  }
  std::int16_t* line(int number) {
    return rows_.data() + slot(number) * static_cast<std::size_t>(step_) + radius_;
  }

  // of the middle and of each distance from it, in units of 2^-15
  std::vector<std::int16_t> weights_;
  int radius_, width_, step_;
  std::size_t slots_;               // a power of two
  std::vector<std::int16_t> rows_;  // ring buffer, each row with radius_ zeros on both sides
  std::vector<std::vector<FaceRun>> filled_;
  std::vector<std::int16_t> sums_, smooth_;
};

}  // namespace alltact
