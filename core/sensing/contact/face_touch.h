// Whether something presses on the contact face: yes, no, or not to be told.
#pragma once

#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/local_depth.h"

#include <vector>

namespace alltact {

/// How surely something presses on the contact face now.
enum class FaceTouch {
  kUnknown = 1,  ///< cannot be told: no face in the picture, no finger, or its first frames
  kFree,
  kTouched,
};

inline constexpr double kTouchedDepth_mm = 0.15;  ///< noise and old dents stay below

/// By depth: kTouched where a region is deeper than kTouchedDepth_mm.
[[nodiscard]] FaceTouch face_touch(const std::vector<ContactRegion>& regions);

/// Before calibration, by a dark patch against the reference: kTouched where more than 0.1 % of the
/// measured face is darker by 12 %; kUnknown where nothing was measured.
[[nodiscard]] FaceTouch face_touch(const Difference& difference);

}  // namespace alltact
