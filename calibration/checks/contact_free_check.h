// Checks with contact-free images whether the light has changed since the reference was recorded.
#pragma once

#include "calibration/checks/press_check.h"
#include "calibration/reference/contact_search.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace alltact {

struct ContactFreeCheck {
  /// kPass: no action needed. kDrifting: the light has changed by more than 2 %, which is corrected
  /// in every image; record again when convenient. kRecalibrate: by more than 6 %, or the remaining
  /// change makes false depth; record the reference again.
  CheckVerdict verdict = CheckVerdict::kPass;
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference, mean of images
  /// False depth, mm, in the worst twentieth of the face (patches of 4 x 4 px): as it is measured,
  /// and without the correction of the light.
  double false_depth_mm = 0, uncorrected_mm = 0;
  double limit_mm = 0;  ///< limit of noise in false depth: 0.02 mm, or three times the noise
  /// The images show skin that is brighter than the reference, which was therefore recorded with a
  /// contact (kRecalibrate).
  std::optional<ReferenceSuspect> suspect;
  int image_count = 0;
  std::vector<Message> left_out;  ///< "frame_3: why"
  Message sentence;               ///< verdict, figures and what to do
};

/// images: see open_source; nothing may touch the face in them. Errors: the finger has no mapping;
/// those of its reference; no image that can be compared; stopped.
[[nodiscard]] Result<ContactFreeCheck> check_contact_free(
    const FingerSnapshot& snapshot, const std::vector<std::filesystem::path>& images,
    const Job& job);

}  // namespace alltact
