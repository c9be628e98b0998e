// The face of one recorded frame, row by row, and nothing else of the picture.
#pragma once

#include "core/sensing/face_shape.h"

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A run of pixels of one row that show the face.
struct FaceRun {
  int row = 0, first = 0, end = 0;  ///< columns [first, end)
};

struct FacePicture {
  std::vector<FaceRun> runs;           ///< by row, then by column
  std::vector<std::size_t> offsets;    ///< where each run's pixels begin in `grey`
  std::vector<std::size_t> row_begin;  ///< first run of each row; one more than rows
  std::vector<std::uint8_t> grey;

  [[nodiscard]] std::size_t bytes() const {
    return grey.size() + runs.size() * (sizeof(FaceRun) + sizeof(std::size_t)) +
           row_begin.size() * sizeof(std::size_t);
  }
};

/// Keeps the pixels at least `margin_px` inside the fitted edges of valid columns.
[[nodiscard]] FacePicture keep_face(const cv::Mat& grey, const FaceShape& shape, double margin_px);

/// sum of weights[i] * frames[i] where all frames show the face: `grey` CV_32FC1 and `valid`
/// CV_8UC1 (255) of the given size, 0 elsewhere. Reuses both where nobody else holds them.
void mix_faces(const std::vector<const FacePicture*>& frames,
               const std::vector<float>& weights,
               const cv::Size& size,
               cv::Mat& grey,
               cv::Mat& valid);

}  // namespace alltact
