// What a twin is fitted to: pictures on disk, measured as a calibration measures them.
#pragma once

#include "calibration/presses/press_input.h"
#include "calibration/twin/twin.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace alltact {

struct TwinFiles {
  PressInput presses;  ///< nothing: those that the finger keeps
  PressSet said;  ///< of the presses, in place of what the finger keeps; radius 0: what that tells
  /// Pictures of the untouched finger, in the pose of its presses; none: the finger's own
  /// reference.
  std::vector<std::filesystem::path> untouched;
};

struct TwinMeasured {
  TwinInput input;
  std::vector<Message> left_out;  ///< presses that cannot be used, "press_3: why"
};

/// Reads and measures, finding the balls. Calibrated or not makes no difference. Errors: no radius
/// is known; no press, or none that can be used, with each one's reason; no untouched picture;
/// pictures that are unreadable, coloured or of another size; those of the finger's reference;
/// stopped.
[[nodiscard]] Result<TwinMeasured> measure_for_twin(const FingerSnapshot& finger,
                                                    const TwinFiles& files,
                                                    const Job& job);

}  // namespace alltact
