// What a pixel's depth inside a contact is off by, from all that is known of its causes.
#pragma once

#include "calibration/calibrate_finger.h"

#include <vector>

namespace alltact {

/// Mean absolute error of depth to be expected of single pixels inside contacts like those of the
/// presses that were used, mm: the mean of their standard deviations by noise, mapping, reference,
/// light and what lies beside them (depth_sd.h), as that of normal errors. 0 where none of the
/// presses shows a contact.
[[nodiscard]] double contact_error_mm(const std::vector<TakenPress>& presses,
                                      const MappingParameters& mapping);

}  // namespace alltact
