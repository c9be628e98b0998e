// Extracts patches of the contact face from a measured frame.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/surface/surface_patch.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The pixels of `box` that have a depth. A large box is sampled at every second, third, ... pixel
/// in both directions, so that about 1500 remain. `smoothing_px`: setting of the measurement. Empty
/// where the frame has no depth.
[[nodiscard]] SurfacePatch patch_in(const FrameResult& result,
                                    const Face& face,
                                    const Mapping& mapping,
                                    double smoothing_px,
                                    const cv::Rect& box);

/// The pixels on a straight line in the image, each once, and their distance from the first one
/// along the untouched face.
struct SurfaceLine {
  SurfacePatch patch;
  std::vector<double> along_mm;
};
[[nodiscard]] SurfaceLine line_between(const FrameResult& result,
                                       const Face& face,
                                       const Mapping& mapping,
                                       double smoothing_px,
                                       cv::Point2d from,
                                       cv::Point2d to);

}  // namespace alltact
