// What one frame of a recording tells, in a few figures: for plots over time.
#pragma once

#include "calibration/live/frame_measurer.h"

#include <optional>

namespace alltact {

struct FrameSummary {
  std::size_t number = 0;
  /// Absent where the finger tells none: of a finger without calibration, of a frame without a
  /// face.
  std::optional<double> deepest_mm, area_mm2;
  std::optional<double> force_N;  ///< its amount
  bool is_touched = false;
  Message problem;  ///< the first one; empty: none
};

[[nodiscard]] FrameSummary summary_of(const MeasuredFrame& frame);

}  // namespace alltact
