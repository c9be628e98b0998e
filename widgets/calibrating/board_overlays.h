// Overlays over the live image: detected board corners, cells without corners, and the grid of a
// known lens.
#pragma once

#include "calibration/lens/board_collector.h"
#include "core/camera/camera.h"
#include "widgets/image/image_view.h"

namespace alltact {

/// Detected corners as rings, filled where the view is worth adding.
[[nodiscard]] Overlay corners_overlay(const BoardAnalysis& detection);
/// Image cells without a corner in any accepted view, hatched.
[[nodiscard]] Overlay unseen_cells_overlay(const BoardCollector::Cells& cells, QSize image_size);
/// Straight lines in the world, evenly spaced in tangents, as projected by this camera.
[[nodiscard]] Overlay lens_grid_overlay(const Camera& camera);

}  // namespace alltact
