// A grid of points as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct Triangles {
  std::vector<cv::Vec3f> points_mm;
  std::vector<float> depth_mm;                       ///< of every point
  std::vector<std::array<std::int32_t, 3>> corners;  ///< anticlockwise seen from the camera
};

/// Leaves out points that are not finite, and their triangles.
///   points_mm: CV_32FC3; depth_mm: CV_32FC1 of the same size
[[nodiscard]] Triangles triangles_of(const cv::Mat& points_mm, const cv::Mat& depth_mm);

}  // namespace alltact
