// Has the light aged since the reference was recorded? Told by pictures of the untouched finger.
#pragma once

#include "calibration/checks/press_check.h"
#include "calibration/reference/reference_suspect.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct UntouchedCheck {
  /// kPass: nothing to do. kDrifting: the light has changed by more than 2 %, which is taken out of
  /// every picture; record again when convenient. kRecalibrate: by more than 6 %, or what is left
  /// after taking it out makes false depth: record the reference again.
  CheckVerdict verdict = CheckVerdict::kPass;
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference, mean of pictures
  /// Depth that is not there, mm, in the worst twentieth of the face (patches of 4 x 4 px): as it
  /// is measured, and what it would be if the light were not corrected.
  double false_depth_mm = 0, uncorrected_mm = 0;
  double limit_mm = 0;  ///< false depth above this is no noise: 0.02 mm, or three times the noise
  /// The pictures show skin that is brighter than the reference: it was touched (kRecalibrate).
  std::optional<ReferenceSuspect> suspect;
  int pictures = 0;
  std::vector<Message> left_out;  ///< "frame_3: why"
  Message sentence;               ///< verdict, figures and what to do
};

/// pictures: see open_source; nothing may touch the face in them. Errors: the finger has no
/// mapping; those of its reference; no picture that can be compared; stopped.
[[nodiscard]] Result<UntouchedCheck> check_untouched(
    const FingerSnapshot& snapshot,
    const std::vector<std::filesystem::path>& pictures,
    const Job& job);

}  // namespace alltact
