#include "core/io/triangles.h"

#include <cmath>

namespace alltact {
namespace {

bool is_finite(const cv::Vec3f& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}  // namespace

Triangles triangles_of(const cv::Mat& points_mm, const cv::Mat& depth_mm) {
  CV_Assert(points_mm.type() == CV_32FC3 && depth_mm.type() == CV_32FC1 &&
            points_mm.size() == depth_mm.size());
  Triangles triangles;
  cv::Mat_<int> number(points_mm.size(), -1);
  for (int v = 0; v < points_mm.rows; ++v) {
    for (int u = 0; u < points_mm.cols; ++u) {
      const auto& p = points_mm.at<cv::Vec3f>(v, u);
      if (!is_finite(p)) continue;
      number(v, u) = static_cast<int>(triangles.points_mm.size());
      triangles.points_mm.push_back(p);
      triangles.depth_mm.push_back(depth_mm.at<float>(v, u));
    }
  }
  const auto add = [&](int a, int b, int c) {
    if (a >= 0 && b >= 0 && c >= 0) triangles.corners.push_back({a, b, c});
  };
  // In the image u grows to the right and v downwards, so anticlockwise is down first.
  for (int v = 0; v + 1 < number.rows; ++v) {
    for (int u = 0; u + 1 < number.cols; ++u) {
      add(number(v, u), number(v + 1, u), number(v, u + 1));
      add(number(v, u + 1), number(v + 1, u), number(v + 1, u + 1));
    }
  }
  return triangles;
}

}  // namespace alltact
