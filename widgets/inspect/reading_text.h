// Readings at two points, as text.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"

#include <QString>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Rich text: positions of A and B with depth and its standard deviation, and their distance.
[[nodiscard]] QString reading_text(const InspectedFrame& frame,
                                   const std::optional<FacePosition>& a,
                                   const std::optional<FacePosition>& b);

/// Reading at the centre of a pixel, with the numbers that `alltact reconstruct` writes; one line
/// of plain text each.
struct ProbeText {
  QString depth;     ///< "depth 0.53 ± 0.02 mm"
  QString position;  ///< "45.2 mm along, 3.1 mm across; x 3.10, y -0.20, z 48.03 mm"
};
/// nullopt outside the face. `pixel`: integers.
[[nodiscard]] std::optional<ProbeText> probe_text(const InspectedFrame& frame, cv::Point2d pixel);

/// "Deepest 0.82 mm at x 3.1, y -0.2, z 48.0 mm."; empty without contact.
[[nodiscard]] QString deepest_text(const InspectedFrame& frame);

}  // namespace alltact
