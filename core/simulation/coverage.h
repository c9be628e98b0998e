// The fraction of each pixel that a convex outline covers.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

struct Coverage {
  cv::Point corner;          ///< top left pixel
  cv::Mat_<float> fraction;  ///< 0..1; empty when the outline lies outside the image
};

/// Exact areas of a convex polygon within pixels, clipped to the image. Pixel (0, 0) covers -0.5 to
/// 0.5.
[[nodiscard]] Coverage convex_coverage(const std::vector<Eigen::Vector2d>& outline, cv::Size size);

/// Centroid of the polygon.
[[nodiscard]] Eigen::Vector2d centre_of_area(const std::vector<Eigen::Vector2d>& outline);

}  // namespace alltact
