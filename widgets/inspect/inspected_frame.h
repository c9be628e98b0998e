// A frame as the place Inspect shows it: measured, made into surfaces, compared.
#pragma once

#include "core/sensing/pipeline.h"
#include "widgets/scene3d/face_surface.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct InspectedFrame {
  std::size_t number = 0;  ///< within the recording
  FrameResult result;
  Face face;
  bool is_calibrated = false;  ///< else there is no depth
  std::optional<Camera> camera;
  cv::Mat sd_mm;  ///< of the depth; empty where there is no depth
  std::optional<FaceSurface> surface;
  /// The other method's, where two are compared.
  std::optional<FrameResult> other;
  std::optional<FaceSurface> other_surface;
  cv::Mat other_depth_mm;  ///< on the first surface's grid
};

/// Depth less the other method's, CV_32FC1, the picture's size; NaN where one of them is missing.
/// Both must have depth.
[[nodiscard]] cv::Mat depth_difference_mm(const InspectedFrame& frame);

}  // namespace alltact
