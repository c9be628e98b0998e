// Smoothing of a picture of which only a part is given, row by row.
#pragma once

#include "core/sensing/depth/smoothing.h"
#include "core/sensing/face/face_runs.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace alltact {

/// Smooths along both axes, keeping only the rows that the kernel spans. What is not given counts
/// as 0: a sum over what is given, not a mean. Outer weights are rounded to 2^-9, the middle one
/// makes their sum 1. Grey levels are in steps (grey_steps.h) and lie within 0 to 250 levels.
class RowSmoother {
 public:
  RowSmoother(const Smoothing& smoothing, int width);

  /// Rows below one that its smoothing needs.
  [[nodiscard]] int radius() const { return radius_; }

  /// The row, 0 but within the face's runs, where every pixel is to be written. Every row is to be
  /// asked for in turn.
  std::int16_t* fresh_row(int number, std::span<const FaceRun> runs);

  /// A run of row `number` as it was given.
  const std::int16_t* raw(int number, const FaceRun& run) { return line(number) + run.first; }

  /// A run of row `number` smoothed; valid until the next call. All rows up to `radius`
  /// below it must have been given.
  const std::int16_t* smoothed(int number, const FaceRun& run);

 private:
  /// Also of rows before the first.
  [[nodiscard]] std::size_t slot(int number) const {
    return static_cast<std::size_t>(number) & (slots_ - 1);
  }
  std::int16_t* line(int number) {
    return rows_.data() + slot(number) * static_cast<std::size_t>(step_) + radius_;
  }

  std::vector<std::int16_t> weights_;  // of the middle and of each distance from it, of 2^-15
  int radius_, width_, step_;
  std::size_t slots_;               // a power of two
  std::vector<std::int16_t> rows_;  // a ring, each with radius_ zeros on both sides
  std::vector<std::vector<FaceRun>> filled_;
  std::vector<std::int16_t> sums_, smooth_;
};

}  // namespace alltact
