// A finger in images of more or fewer pixels than its camera's, for timing.
#pragma once

#include "calibration/study/study_world.h"
#include "core/finger/finger_store.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Images of a finger's recording in their original size, with the marker table; of a flat sensor
/// its single image.
struct RecordedImages {
  MarkerTable table;            ///< rows of `images`; empty of a flat sensor
  std::vector<cv::Mat> images;  ///< oriented
};

/// At most `count` images, evenly over the recording. Errors: the finger is not calibrated; those
/// of its recording; stopped.
[[nodiscard]] Result<RecordedImages> recorded_images(const FingerPtr& finger,
                                                     int count,
                                                     const Job& job);

struct ScaledFinger {
  FingerSnapshot finger;  ///< its camera has the size of the images below, which are oriented
  ReferenceLibrary library;
  /// each with a ball painted into it, where a valid position was found
  std::vector<FramePtr> frames;

  [[nodiscard]] Pipeline pipeline() const { return Pipeline::with_library(library, finger, {}); }
};

/// by: factor on pixels a side, 0.05 to 8. Errors: those of Camera::create and ReferenceLibrary.
[[nodiscard]] Result<ScaledFinger> scaled_finger(const FingerSnapshot& finger,
                                                 const RecordedImages& recorded,
                                                 double by,
                                                 std::uint64_t seed,
                                                 const Job& job);

}  // namespace alltact
