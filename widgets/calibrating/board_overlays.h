// What is drawn over the live picture while a lens is measured, and of a lens that is known.
#pragma once

#include "calibration/lens/board_collector.h"
#include "core/camera/camera.h"
#include "widgets/picture/image_view.h"

namespace alltact {

/// The corners as they were found: rings, filled where the view is worth keeping.
[[nodiscard]] Overlay corners_overlay(const BoardLook& look);
/// The cells of a picture in which no kept view shows a corner yet, hatched.
[[nodiscard]] Overlay unseen_cells_overlay(const BoardCollector::Cells& cells, QSize picture);
/// Straight lines of the world, evenly spaced in tangents, as this camera shows them.
[[nodiscard]] Overlay lens_grid_overlay(const Camera& camera);

}  // namespace alltact
