// What a study finds, as a finger keeps it.
#pragma once

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/study_front.h"

#include <string>

namespace alltact {

/// The study's presets (presets_of), to be kept with keep_presets(): balanced always, fast and
/// finest where they bring something. The study's base is taken for the calibration's settings.
///   machine: processor and number of threads, for people
[[nodiscard]] MeasuringPresets presets_to_keep(const AccuracyStudy& study,
                                               const std::string& machine);

}  // namespace alltact
