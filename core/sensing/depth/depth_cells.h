// Mean depth over small square cells: contacts show in a sixteenth of the numbers, with less noise
// than in single pixels.
#pragma once

#include "core/sensing/face/face_runs.h"

#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

constexpr int kDepthCellPx = 4;  ///< a side

/// Accumulated row by row while the depths are in the processor's cache.
class DepthCells {
 public:
  explicit DepthCells(const cv::Size& image_size);

  /// Rows are added in order, from 0 to the last. `depth_mm`: the full row; only the runs are read,
  /// and NaN counts as 0.
  void add_row(int row, std::span<const FaceRun> runs, const float* depth_mm);
  /// CV_32FC1, mm, one value per cell. Cells that the image border cuts are divided by the full
  /// area.
  [[nodiscard]] const cv::Mat& mean_mm() const { return mean_mm_; }

 private:
  cv::Size image_size_;
  cv::Mat mean_mm_;
  std::vector<float> sum_;  // of a row of cells, by column
};

/// The same from a complete depth map, CV_32FC1.
[[nodiscard]] cv::Mat depth_cells(const cv::Mat& depth_mm);

}  // namespace alltact
