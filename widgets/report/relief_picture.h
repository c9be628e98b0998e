// Reliefs beside each other, in colours with their scales.
#pragma once

#include "calibration/experiments/experiment_plot.h"

#include <QImage>

namespace alltact {

/// Depths in a row, and below each but the first, the truth, its difference from it; in the place
/// below the truth the two scales in mm and a length of 5 mm. All depths in one scale of colours,
/// all differences in another; grey where nothing is told.
///   width: px at 96 to the inch, of `sharpness` pixels each way
[[nodiscard]] QImage relief_picture(const ExperimentMaps& maps, int width, double sharpness);

}  // namespace alltact
