// Whether something presses on the contact face: yes, no, or unknown.
#pragma once

#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/local_depth.h"

#include <vector>

namespace alltact {

/// State of the contact face.
enum class FaceContact {
  kUnknown = 1,  ///< no face in the image, no finger, or its first frames
  kFree,
  kInContact,
};

inline constexpr double kContactDepth_mm = 0.15;  ///< above noise and permanent indentations

/// From depth: kInContact where a region is deeper than kContactDepth_mm.
[[nodiscard]] FaceContact face_contact(const std::vector<ContactRegion>& regions);

/// Before calibration, from a dark area against the reference: kInContact where more than 0.1 % of
/// the measured face is darker by 12 %; kUnknown where nothing was measured.
[[nodiscard]] FaceContact face_contact(const Difference& difference);

}  // namespace alltact
