// Which pixels of a picture show the face, as runs along its rows: what loops over pixels go by.
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
  std::uint32_t before = 0;         ///< pixels of the face in the runs before this one

  [[nodiscard]] int size() const { return end - first; }
};

struct FaceRuns {
  std::vector<FaceRun> runs;             ///< by row, then by column; none is empty
  std::vector<std::uint32_t> row_begin;  ///< first run of each row; one more than rows

  [[nodiscard]] std::span<const FaceRun> of_row(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return {runs.data() + row_begin[r], runs.data() + row_begin[r + 1]};
  }
  [[nodiscard]] std::uint32_t pixels() const {
    return runs.empty() ? 0 : runs.back().before + static_cast<std::uint32_t>(runs.back().size());
  }
};

/// The pixels at least `margin_px` inside the face's edges, in columns that are valid and among
/// `columns`.
[[nodiscard]] FaceRuns face_runs(const FaceShape& shape,
                                 double margin_px,
                                 const cv::Size& size,
                                 const cv::Range& columns = cv::Range::all());

/// Mean brightness of the face, grey levels, from some of its rows; 1 where there is no face.
[[nodiscard]] double mean_brightness(const cv::Mat& grey, const FaceRuns& face);

}  // namespace alltact
