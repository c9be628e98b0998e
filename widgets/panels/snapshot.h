// Saves an image of the current view to a chosen file.
#pragma once

#include "widgets/image/image_view.h"

namespace alltact {

/// `grey` (CV_8UC1) in its own size, with the overlays.
[[nodiscard]] QImage image_with_overlays(const cv::Mat& grey, const std::vector<Overlay>& overlays);

/// Opens a file dialog without blocking the window, and saves the image of this moment: with the
/// overlays or, by another filter, as the camera gave it. A dialog reports a failure to write.
void choose_snapshot(const cv::Mat& grey, const std::vector<Overlay>& overlays, QWidget& parent);

}  // namespace alltact
