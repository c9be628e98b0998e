// What was measured at two points, in words.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"

#include <QString>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Rich text: places of A and B with depth and its standard deviation, and how far they are apart.
[[nodiscard]] QString reading_text(const InspectedFrame& frame,
                                   const std::optional<FacePlace>& a,
                                   const std::optional<FacePlace>& b);

/// What lies at the middle of a pixel, as `alltact reconstruct` writes it: plain text of a line
/// each.
struct ProbeText {
  QString depth;  ///< "depth 0.53 ± 0.02 mm"
  QString place;  ///< "45.2 mm along, 3.1 mm across; x 3.10, y -0.20, z 48.03 mm"
};
/// nullopt off the face. `pixel`: whole numbers.
[[nodiscard]] std::optional<ProbeText> probe_text(const InspectedFrame& frame, cv::Point2d pixel);

/// "Deepest 0.82 mm at x 3.1, y -0.2, z 48.0 mm."; empty where nothing presses.
[[nodiscard]] QString deepest_text(const InspectedFrame& frame);

}  // namespace alltact
