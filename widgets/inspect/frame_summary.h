// Summary of one frame of a recording, for plots over time.
#pragma once

#include "calibration/live/frame_measurer.h"

#include <optional>

namespace alltact {

struct FrameSummary {
  std::size_t number = 0;
  /// Empty for a finger without calibration and for a frame without a face.
  std::optional<double> deepest_mm, area_mm2;
  std::optional<double> force_N;  ///< magnitude
  bool has_contact = false;
  Message problem;  ///< the first one; empty: none
};

[[nodiscard]] FrameSummary summary_of(const MeasuredFrame& frame);

}  // namespace alltact
