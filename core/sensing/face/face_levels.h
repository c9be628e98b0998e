// Grey levels of the face, for the adjustment of camera and lamp.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <array>

#include <opencv2/core.hpp>

namespace alltact {

struct FaceLevels {
  static constexpr int kLevelsPerBin = 4;

  /// Pixels by grey level: of the face, or of the entire image where no face was found.
  std::array<int, 256 / kLevelsPerBin> counts{};
  bool is_of_face = false;
  /// Fractions of these pixels that are clipped, or too dark for a reference (grey_range.h).
  double too_bright = 0, too_dark = 0;
};

/// grey: CV_8UC1, oriented. edges: of this image; null: none were found.
[[nodiscard]] FaceLevels face_levels(const cv::Mat& grey, const FaceEdges* edges);

}  // namespace alltact
