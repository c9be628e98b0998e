// Row by row smoothing of an image of which only a part is given.
#pragma once

#include "core/sensing/depth/smoothing.h"
#include "core/sensing/face/face_runs.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace alltact {

/// Smooths along both axes and stores only the rows that the kernel spans. Missing pixels count as
/// 0: the result is a sum over the given pixels, not a mean. Outer weights are rounded to 2^-9; the
/// middle one makes their sum 1. Grey levels are in steps (grey_steps.h) and lie within 0 to 250
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
