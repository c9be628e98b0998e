// Borders of the side faces by column: the search area for markers.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alltact {

/// Edges of the view face for every column of the image. Untrusted columns get the straight
/// continuation of the nearest trusted ones, so that an unmeasured part of the face is not mistaken
/// for a side face.
struct SideEdges {
  std::vector<float> upper, lower;  ///< px, upper <= lower

  explicit SideEdges(const FaceShape& shape);

  /// Rows of one side face in column u at least `margin_px` off the view face.
  struct Rows {
    int first, last;
  };
  [[nodiscard]] Rows rows(int u, bool upper_side, double margin_px, int height) const {
    const auto column = static_cast<std::size_t>(u);
    if (upper_side)
      return {0, std::min(height - 1, static_cast<int>(std::floor(upper[column] - margin_px)))};
    return {std::max(0, static_cast<int>(std::ceil(lower[column] + margin_px))), height - 1};
  }
  /// Distance of a row from the view face on one side, px; negative on the face.
  [[nodiscard]] double off_px(int u, double v, bool upper_side) const {
    const auto column = static_cast<std::size_t>(u);
    return upper_side ? static_cast<double>(upper[column]) - v
                      : v - static_cast<double>(lower[column]);
  }
  [[nodiscard]] float middle(int u) const {
    const auto column = static_cast<std::size_t>(u);
    return 0.5F * (upper[column] + lower[column]);
  }
};

}  // namespace alltact
