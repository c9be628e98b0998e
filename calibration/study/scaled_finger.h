// A finger in pictures of more or fewer pixels than its camera gives, to measure time with.
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

/// Pictures of a finger's recording at their own size, with the table of its markers; of a flat
/// sensor its one picture.
struct RecordedPictures {
  MarkerTable table;              ///< rows of `pictures`; empty of a flat sensor
  std::vector<cv::Mat> pictures;  ///< turned already
};

/// At most so many, evenly over the recording. Errors: the finger is not calibrated; those of its
/// recording; stopped.
[[nodiscard]] Result<RecordedPictures> recorded_pictures(const FingerPtr& finger,
                                                         int count,
                                                         const Job& job);

struct ScaledFinger {
  FingerSnapshot finger;  ///< its camera gives the pictures below; they are turned already
  ReferenceLibrary library;
  std::vector<FramePtr> frames;  ///< each with a ball painted into it, where one found its place

  [[nodiscard]] Pipeline pipeline() const { return Pipeline::over(library, finger, {}); }
};

/// by: of pixels a side, 0.05 to 8. Errors: those of Camera::create and ReferenceLibrary.
[[nodiscard]] Result<ScaledFinger> scaled_finger(const FingerSnapshot& finger,
                                                 const RecordedPictures& recorded,
                                                 double by,
                                                 std::uint64_t seed,
                                                 const Job& job);

}  // namespace alltact
