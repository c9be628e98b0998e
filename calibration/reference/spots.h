// Compact spots on the face that differ from their surroundings.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

struct Spot {
  double lower = 0;           ///< than its surroundings, at its lowest
  Eigen::Vector2d centre_px;  ///< its middle: column, row
  double area_mm2 = 0;
};

struct SpotSearch {
  Eigen::Vector2d mm_per_px;  ///< along columns, along rows
  /// false: regions higher than their surroundings by 0.03, and 4 mm around them, are excluded
  bool near_higher = true;
};

/// The lowest spot of `x` (CV_32F) of 1 to 150 mm^2 that is below its surroundings by 0.03 and by 8
/// robust standard deviations, each averaged over 1.5 mm. known: CV_8UC1, not 0 where x counts.
[[nodiscard]] std::optional<Spot> find_spot(const cv::Mat& x,
                                            const cv::Mat& known,
                                            const SpotSearch& search);

}  // namespace alltact
