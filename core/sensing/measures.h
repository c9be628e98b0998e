// Point, profile and distance measurements on a measured face.
#pragma once

#include "core/sensing/pipeline.h"

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Bilinear interpolation between four pixels. `image`: CV_32FC1. NaN where a neighbour has no
/// value or lies outside.
[[nodiscard]] float bilinear_value(const cv::Mat& image, double u, double v);

/// The contact face at a sub-pixel position.
struct FaceSample {
  cv::Point2d pixel;
  Eigen::Vector3d untouched_mm;    ///< of the unloaded contact face
  std::optional<double> depth_mm;  ///< along z; empty where it was not measured
  std::optional<double> sd_mm;     ///< of the depth
  std::uint8_t flag = kMeasured;   ///< why depth is missing or doubtful
  /// On the contact face. Without a depth: on the untouched face.
  [[nodiscard]] Eigen::Vector3d point_mm() const {
    return untouched_mm - Eigen::Vector3d(0, 0, depth_mm.value_or(0));
  }
};

/// nullopt off the face. `sd_mm`: as depth_sd_mm() returns it; may be empty.
[[nodiscard]] std::optional<FaceSample> sample_face(const FrameResult& result,
                                                    const Face& face,
                                                    const cv::Mat& sd_mm,
                                                    cv::Point2d pixel);

/// Distance between two points of the contact face.
struct Distance {
  double straight_mm = 0;
  double along_face_mm = 0;  ///< along the contact face, over the straight line in the image
  Eigen::Vector3d apart_mm;  ///< second less first
};

/// Depth along the straight line in the image from one position to another.
struct Profile {
  std::vector<cv::Point2d> pixels;
  std::vector<double> along_mm;  ///< path length over the untouched face from the first position
  std::vector<double> depth_mm;  ///< NaN where it was not measured
  std::vector<double> sd_mm;     ///< NaN where it is not known
};

/// Takes one step a pixel, at least two. Positions off the face are left out.
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
