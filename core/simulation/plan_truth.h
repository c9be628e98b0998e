// The truth of a frame.
#pragma once

#include "core/simulation/frame_plan.h"
#include "core/simulation/truth.h"

namespace alltact {

[[nodiscard]] Truth truth_of(const FramePlan& plan,
                             const FrameGeometry& geometry,
                             TruthDetail detail);

/// The part given by the view face alone: all but `untouched_grey`, and `seen` without the sides.
[[nodiscard]] TruthMaps truth_maps_of(const FrameGeometry& geometry);

/// Marks dots, and folds over dots, next to the face in `seen` (TruthMaps::seen).
void mark_dots(const FrameGeometry& geometry, cv::Mat& labels);

}  // namespace alltact
