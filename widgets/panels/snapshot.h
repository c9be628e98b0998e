// A picture of what is shown, saved where somebody says.
#pragma once

#include "widgets/picture/image_view.h"

namespace alltact {

/// `grey` (CV_8UC1) in its own size, with what is drawn over it.
[[nodiscard]] QImage drawn_picture(const cv::Mat& grey, const std::vector<Overlay>& overlays);

/// Asks for a file, beside the window, and saves the picture as it is now: with what is drawn over
/// it or, by another filter, as the camera gave it. What cannot be written is told in a dialog.
void choose_snapshot(const cv::Mat& grey, const std::vector<Overlay>& overlays, QWidget& parent);

}  // namespace alltact
