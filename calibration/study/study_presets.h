// The presets of a study, in the form that a finger stores.
#pragma once

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/study_front.h"

#include <string>

namespace alltact {

/// The study's presets (presets_of), for save_presets(): balanced always, fast and finest where
/// they improve something. The study's base counts as the calibration's settings.
///   machine: processor and number of threads, for people
[[nodiscard]] MeasuringPresets presets_to_save(const AccuracyStudy& study,
                                               const std::string& machine);

}  // namespace alltact
