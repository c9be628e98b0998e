// Rigid presses as grids, for effects of the layer.
#pragma once

#include "core/simulation/frame_geometry.h"

namespace alltact {

/// Samples the press's depth on a grid of face positions, 0.05 mm apart, or coarser so that the
/// body spans at most 600 steps.
[[nodiscard]] SampledPress sample_press(const BodyPress& press, const FrameGeometry& geometry);

/// All rigid presses of a frame.
void sample_bodies(FrameGeometry& geometry);

/// Adds `steps` without a press on every side of the grid.
void pad_grid(SampledPress& press, int steps);

}  // namespace alltact
