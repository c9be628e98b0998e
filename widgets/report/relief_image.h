// Depth maps next to each other, in colours with their scales.
#pragma once

#include "calibration/experiments/experiment_plot.h"

#include <QImage>

namespace alltact {

/// Depth maps in a row; below each but the first, the truth, its difference from it. Below the
/// truth: the two scales in mm and a length of 5 mm. All depths share one scale of colours, all
/// differences another; grey where there is no value.
///   width: px at 96 to the inch, with `sharpness` pixels along each side of one
[[nodiscard]] QImage relief_image(const ExperimentMaps& maps, int width, double sharpness);

}  // namespace alltact
