// The connected part of a press's samples that a body presses in, for bodies other than balls.
#pragma once

#include "calibration/presses/press.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {

/// Blocks of about `max_samples` in the entire face; their side in px.
[[nodiscard]] inline int block_px_for(const Press& press, double max_samples) {
  const double finite = cv::countNonZero(measured_pixels(press.difference.x));
  return std::max(2, static_cast<int>(std::ceil(std::sqrt(finite / max_samples))));
}

/// Position of a sample in an image that has one pixel a block, and a free border of one.
[[nodiscard]] inline cv::Point cell_of(const Sample& sample, int block_px) {
  return {static_cast<int>(std::floor(sample.pixel.x() / block_px)) + 1,
          static_cast<int>(std::floor(sample.pixel.y() / block_px)) + 1};
}

/// 255 in the cells of the largest connected part (of 4 or 8 neighbours) of the samples for which
/// `is_in` holds; 0 everywhere where there is none. CV_8UC1.
template <class IsIn>
[[nodiscard]] cv::Mat largest_part(const PressSamples& press, const IsIn& is_in, int neighbours) {
  cv::Point last;
  for (const Sample& sample : press.samples) {
    const cv::Point cell = cell_of(sample, press.block_px);
    last = {std::max(last.x, cell.x), std::max(last.y, cell.y)};
  }
  cv::Mat mask(last.y + 2, last.x + 2, CV_8UC1, cv::Scalar(0)), labels, stats, centres;
  for (const Sample& sample : press.samples)
    if (is_in(sample)) mask.at<std::uint8_t>(cell_of(sample, press.block_px)) = 255;
  const int count =
      cv::connectedComponentsWithStats(mask, labels, stats, centres, neighbours, CV_32S);
  int largest = 0, area = 0;
  for (int i = 1; i < count; ++i)
    if (stats.at<int>(i, cv::CC_STAT_AREA) > area)
      largest = i, area = stats.at<int>(i, cv::CC_STAT_AREA);
  if (largest == 0) return mask;  // empty
  return labels == largest;
}

}  // namespace alltact
