// A frame of the page Inspect: measured, compared, converted to surfaces.
#pragma once

#include "calibration/live/frame_measurer.h"
#include "widgets/scene3d/face_surface.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct InspectedFrame : MeasuredFrame {
  std::optional<FaceSurface> surface;
  /// For a finger without calibration: the shape of its full face, all of its depth NaN.
  std::optional<FaceSurface> bare;
  std::optional<FaceSurface> other_surface;  ///< of `other`
  cv::Mat other_depth_mm;                    ///< on the first surface's grid
};

}  // namespace alltact
