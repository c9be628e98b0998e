// Pixels of an image that show the face, as runs along its rows, for loops over pixels.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <cstdint>
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
[[nodiscard]] FaceRuns face_runs(const FaceShape& shape,
                                 double margin_px,
                                 const cv::Size& size,
                                 const cv::Range& columns = cv::Range::all());

/// Mean brightness of the face, grey levels, from a subset of its rows; 1 without a face.
[[nodiscard]] double mean_brightness(const cv::Mat& grey, const FaceRuns& face);

}  // namespace alltact
