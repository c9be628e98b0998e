// Pieces of the contact face out of a measured frame.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/surface/surface_patch.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// The pixels of `box` that have a depth; of a large box every second, third ... one each way, so
/// that there are at most about 1500. `smoothing_px`: what the frame was measured with. Empty where
/// the frame has no depth.
[[nodiscard]] SurfacePatch patch_in(const FrameResult& result,
                                    const Face& face,
                                    const Mapping& mapping,
                                    double smoothing_px,
                                    const cv::Rect& box);

/// The pixels that a straight line in the picture goes over, each once, and how far along the
/// untouched face they lie from the first one.
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
