// Error of a pixel's depth inside a contact, from all known causes.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/report/press_residuals.h"
#include "core/finger/mapping.h"

#include <vector>

namespace alltact {

struct Reference;

/// A press and its reference, both of which must outlive it.
struct ComparedPress {
  const Press* press = nullptr;
  const Reference* reference = nullptr;
};

/// Errors of single pixels under the balls, mm along z.
struct ContactError {
  double mean_mm = 0;                ///< mean absolute, of all causes; 0: unknown
  double sd_without_mapping_mm = 0;  ///< standard deviation of all causes but the mapping
};

/// The median over presses of the pixels' mean standard deviation by noise, mapping, reference,
/// light and neighbouring contacts (depth_sd.h). The median is used because gaps of the recording
/// at one position do not apply to the others. Poses beyond the recording count as known ones.
/// `contacts`: those of press_residuals.h, found by name. 0 where no press shows a contact deeper
/// than 0.1 mm.
[[nodiscard]] ContactError contact_error(const std::vector<ComparedPress>& presses,
                                         const std::vector<PressResiduals>& contacts,
                                         const MappingParameters& mapping);

}  // namespace alltact
