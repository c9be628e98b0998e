// What is known of a frame besides its picture.
#pragma once

#include "core/simulation/frame_plan.h"
#include "core/simulation/truth.h"

namespace alltact {

[[nodiscard]] Truth truth_of(const FramePlan& plan,
                             const FrameGeometry& geometry,
                             TruthDetail detail);

/// What the view face alone tells: all but `untouched_grey`, and `seen` without the sides.
[[nodiscard]] TruthMaps truth_maps_of(const FrameGeometry& geometry);

/// Marks in `seen` (TruthMaps::seen) where dots are, or folds over them, beside the face.
void mark_dots(const FrameGeometry& geometry, cv::Mat& seen);

}  // namespace alltact
