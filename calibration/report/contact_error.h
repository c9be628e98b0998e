// What a pixel's depth inside a contact is off by, from all that is known of its causes.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/report/press_residuals.h"
#include "core/finger/mapping.h"

#include <vector>

namespace alltact {

struct Reference;

/// A press with what it was compared with, both of which must live as long.
struct ComparedPress {
  const Press* press = nullptr;
  const Reference* reference = nullptr;
};

/// What single pixels under the balls are off by, mm along z.
struct ContactError {
  double mean_mm = 0;                ///< mean absolute, of all causes; 0: unknown
  double sd_without_mapping_mm = 0;  ///< standard deviation of all causes but the mapping
};

/// The means of the pixels' standard deviations by noise, mapping, reference, light and what lies
/// beside them (depth_sd.h), of each press; of the presses the one in the middle, because what the
/// recording does not show at one position is no property of the others; poses beyond the recording
/// are taken for known ones. `contacts`: those of press_residuals.h, found by name. 0 where no
/// press shows a contact deeper than 0.1 mm.
[[nodiscard]] ContactError contact_error(const std::vector<ComparedPress>& presses,
                                         const std::vector<PressResiduals>& contacts,
                                         const MappingParameters& mapping);

}  // namespace alltact
