// The skin of one recorded frame, warped to the common grid of all frames.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/face_chart.h"

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The common image grid to which all frames of a recording are warped: the face of the rest frame,
/// extended a little at both ends. Its pixel (0, 0) is the rest frame's `origin`.
struct FaceGrid {
  FaceChart chart;  ///< in the rest frame's pixels
  cv::Point origin;
  cv::Size size;
  FaceRuns runs;  ///< of this grid, 2 px wider than the face on both sides
};

/// `part`: fraction of the rest frame's face by which the grid extends beyond each end.
[[nodiscard]] FaceGrid face_grid(const FaceChart& rest, double part);

struct FaceImage {
  int first = 0, end = 0;          ///< columns of the grid that the frame shows
  std::vector<std::uint8_t> grey;  ///< the grid's runs one after the other; 0 off those columns

  [[nodiscard]] std::size_t bytes() const { return grey.size(); }
};

/// Samples a frame (CV_8UC1) at the skin of each of the grid's pixels (CubicSampler).
[[nodiscard]] FaceImage warp_face(const cv::Mat& grey,
                                  const FaceChart& chart,
                                  const FaceGrid& grid);

}  // namespace alltact
