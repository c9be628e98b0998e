// Overlays of the live image, and the readout of a pixel.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/image/image_view.h"

#include <QString>
#include <vector>

namespace alltact {

struct ViewOptions {
  bool edges = true, markers = true, direction = true, depth = true, faults = false;
  double depth_top_mm = 1.0;  ///< end of the depth colour scale, [0.1, 10]
  bool operator==(const ViewOptions&) const = default;
};

[[nodiscard]] std::vector<Overlay> overlays_for(const LiveView& view, const ViewOptions& options);

/// "u 120 px, v 44 px, grey 131, depth 0.42 mm"; the reason where there is no depth.
[[nodiscard]] QString readout_text(const LiveView& view, QPoint pixel);

}  // namespace alltact
