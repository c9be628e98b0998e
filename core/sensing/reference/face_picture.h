// The skin that one recorded frame shows, laid over that of all others.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/face_chart.h"

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The picture that all frames of a recording are laid into: the face as the recording's rest frame
/// shows it, continued a little beyond its ends. Its pixel (0, 0) is the rest frame's `origin`.
struct FaceGrid {
  FaceChart chart;  ///< in the rest frame's pixels
  cv::Point origin;
  cv::Size size;
  FaceRuns runs;  ///< of this picture, 2 px wider than the face on both sides
};

/// `part`: of the rest frame's face that the grid reaches beyond each end.
[[nodiscard]] FaceGrid face_grid(const FaceChart& rest, double part);

struct FacePicture {
  int first = 0, end = 0;          ///< columns of the grid that the frame shows
  std::vector<std::uint8_t> grey;  ///< the grid's runs one after the other; 0 off those columns

  [[nodiscard]] std::size_t bytes() const { return grey.size(); }
};

/// Samples a frame (CV_8UC1) at the skin of each of the grid's pixels (CubicPicture).
[[nodiscard]] FacePicture keep_face(const cv::Mat& grey,
                                    const FaceChart& chart,
                                    const FaceGrid& grid);

}  // namespace alltact
