// A frame as the place Inspect shows it: measured, compared, made into surfaces.
#pragma once

#include "calibration/live/frame_measurer.h"
#include "widgets/scene3d/face_surface.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct InspectedFrame : MeasuredFrame {
  std::optional<FaceSurface> surface;
  /// Of a finger without calibration: the shape of its whole face, all of its depth NaN.
  std::optional<FaceSurface> bare;
  std::optional<FaceSurface> other_surface;  ///< of `other`
  cv::Mat other_depth_mm;                    ///< on the first surface's grid
};

}  // namespace alltact
