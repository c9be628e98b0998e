// Pixels of an image that show the face, as runs along its rows, for loops over pixels.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A run of pixels of one row that show the face.
struct FaceRun {
  int row = 0, first = 0, end = 0;  ///< columns [first, end)
  std::uint32_t before = 0;         ///< face pixels in the runs before this one

  [[nodiscard]] int size() const { return end - first; }
};

struct FaceRuns {
  std::vector<FaceRun> runs;             ///< by row, then by column; none is empty
  std::vector<std::uint32_t> row_begin;  ///< index of the first run of each row; rows + 1 values

  [[nodiscard]] std::span<const FaceRun> of_row(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return {runs.data() + row_begin[r], runs.data() + row_begin[r + 1]};
  }
  [[nodiscard]] std::uint32_t pixels() const {
    return runs.empty() ? 0 : runs.back().before + static_cast<std::uint32_t>(runs.back().size());
  }
};

/// The pixels at least `margin_px` inside the edges of the face, in valid columns among `columns`.
[[nodiscard]] FaceRuns face_runs(const FaceShape& shape, double margin_px, const cv::Size& size,
                                 const cv::Range& columns = cv::Range::all());

/// Mean brightness of the face, grey levels, from a subset of its rows; 1 without a face.
[[nodiscard]] double mean_brightness(const cv::Mat& grey, const FaceRuns& face);

// A section of the face's length that depth is limited to.

/// In mm along the face from its base (FaceShape::length_at). Default: the full face.
struct FaceRegion {
  double from_mm = 0;
  double to_mm = std::numeric_limits<double>::infinity();

  bool operator==(const FaceRegion&) const = default;
};

/// Columns of the image that show the section; an empty range where none does. Range::all() for the
/// full face.
[[nodiscard]] cv::Range columns_of(const FaceRegion& region, const FaceShape& shape);

// Borders of the side faces by column: the search area for markers.

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
