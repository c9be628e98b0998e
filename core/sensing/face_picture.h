// The face of one recorded frame, row by row, and nothing else of the picture.
#pragma once

#include "core/sensing/face_runs.h"

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct FacePicture {
  FaceRuns face;
  std::vector<std::uint8_t> grey;  ///< the runs' pixels one after the other

  [[nodiscard]] std::size_t bytes() const {
    return grey.size() + face.runs.size() * sizeof(FaceRun) +
           face.row_begin.size() * sizeof(std::uint32_t);
  }
};

/// Keeps the pixels at least `margin_px` inside the fitted edges of valid columns.
[[nodiscard]] FacePicture keep_face(const cv::Mat& grey, const FaceShape& shape, double margin_px);

}  // namespace alltact
