// Mean depth over small square cells: where something is touched can be seen in a sixteenth of the
// numbers, and with less noise than pixel by pixel.
#pragma once

#include "core/sensing/face/face_runs.h"

#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

constexpr int kDepthCellPx = 4;  ///< a side

/// Gathered row by row while the depths are still near the processor.
class DepthCells {
 public:
  explicit DepthCells(const cv::Size& picture);

  /// Rows are to be added in turn, from 0 to the last. `depth_mm`: the whole row; only the runs are
  /// read, NaN counts as untouched.
  void add_row(int row, std::span<const FaceRun> runs, const float* depth_mm);
  /// CV_32FC1, mm, one number a cell; cells that the picture cuts are divided like whole ones.
  [[nodiscard]] const cv::Mat& mean_mm() const { return mean_mm_; }

 private:
  cv::Size picture_;
  cv::Mat mean_mm_;
  std::vector<float> sum_;  // of a row of cells, column by column
};

/// The same from a whole depth map, CV_32FC1.
[[nodiscard]] cv::Mat depth_cells(const cv::Mat& depth_mm);

}  // namespace alltact
