// Input of a twin: images on disk, measured as a calibration measures them.
#pragma once

#include "calibration/presses/press_input.h"
#include "calibration/twin/twin.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"

#include <filesystem>
#include <vector>

namespace alltact {

struct TwinFiles {
  PressInput presses;  ///< empty: those stored with the finger
  PressSet
      press_set;  ///< of the presses, overrides the finger's stored notes; radius 0: the stored one
  /// Images of the untouched finger, in the pose of its presses; empty: the finger's own reference.
  std::vector<std::filesystem::path> untouched;
};

struct TwinMeasured {
  TwinInput input;
  std::vector<Message> left_out;  ///< presses that cannot be used, "press_3: why"
};

/// Reads and measures the images, and finds the balls. The finger need not be calibrated. Errors:
/// no radius is known; no press, or no usable press, with each one's reason; no untouched image;
/// images that are unreadable, coloured or of another size; those of the finger's reference;
/// stopped.
[[nodiscard]] Result<TwinMeasured> measure_for_twin(const FingerSnapshot& finger,
                                                    const TwinFiles& files,
                                                    const Job& job);

}  // namespace alltact
