// Which part of each pixel a convex outline covers.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

struct Coverage {
  cv::Point corner;      ///< top left pixel
  cv::Mat_<float> part;  ///< 0..1; empty when the outline lies outside the picture
};

/// Exact areas of a convex polygon within pixels (pixel (0, 0) reaches from -0.5 to 0.5), clipped
/// to the picture.
[[nodiscard]] Coverage convex_coverage(const std::vector<Eigen::Vector2d>& outline, cv::Size size);

/// Centre of the polygon's area.
[[nodiscard]] Eigen::Vector2d centre_of_area(const std::vector<Eigen::Vector2d>& outline);

}  // namespace alltact
