// What can be read off a measured face: places, distances, profiles.
#pragma once

#include "core/sensing/pipeline.h"

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// `picture`: CV_32FC1. Its value between four pixels; NaN where one of them has none or lies
/// outside.
[[nodiscard]] float value_between(const cv::Mat& picture, double u, double v);

/// The contact face at a pixel, with fractions.
struct PlaceReading {
  cv::Point2d pixel;
  Eigen::Vector3d untouched_mm;    ///< as if nothing pressed
  std::optional<double> depth_mm;  ///< along z; none where it was not measured
  std::optional<double> sd_mm;     ///< of the depth
  std::uint8_t flag = kMeasured;   ///< why there is no depth, or a doubtful one
  /// Of the contact face; where there is no depth, of the untouched one.
  [[nodiscard]] Eigen::Vector3d point_mm() const {
    return untouched_mm - Eigen::Vector3d(0, 0, depth_mm.value_or(0));
  }
};

/// nullopt off the face. `sd_mm`: as depth_sd_mm() gives it; may be empty.
[[nodiscard]] std::optional<PlaceReading> read_place(const FrameResult& result,
                                                     const Face& face,
                                                     const cv::Mat& sd_mm,
                                                     cv::Point2d pixel);

/// Between two places of the contact face.
struct Distance {
  double straight_mm = 0;
  double over_face_mm = 0;   ///< along the contact face, above the straight line in the picture
  Eigen::Vector3d apart_mm;  ///< second less first
};

/// Depth along the straight line in the picture from one place to another.
struct Profile {
  std::vector<cv::Point2d> pixels;
  std::vector<double> along_mm;  ///< way over the untouched face from the first place
  std::vector<double> depth_mm;  ///< NaN where it was not measured
  std::vector<double> sd_mm;     ///< NaN where it is not known
};

/// One step a pixel, at least two. Places off the face are left out.
[[nodiscard]] Profile profile_between(const FrameResult& result,
                                      const Face& face,
                                      const cv::Mat& sd_mm,
                                      cv::Point2d from,
                                      cv::Point2d to);

/// nullopt where one of them is off the face.
[[nodiscard]] std::optional<Distance> distance_between(const FrameResult& result,
                                                       const Face& face,
                                                       cv::Point2d from,
                                                       cv::Point2d to);

}  // namespace alltact
