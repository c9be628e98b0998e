// Rigid presses as grids, for what the layer does about them.
#pragma once

#include "core/simulation/frame_geometry.h"

namespace alltact {

/// The press's depth over a grid of places of the face, 0.05 mm apart or as coarse as 600 steps
/// over the body make it.
[[nodiscard]] SampledPress sampled(const BodyPress& press, const FrameGeometry& geometry);

/// All rigid presses of a frame.
void sample_bodies(FrameGeometry& geometry);

/// The grid with `steps` more on every side, where nothing presses.
void widen(SampledPress& press, int steps);

}  // namespace alltact
