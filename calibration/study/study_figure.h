// Plots of studies.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/calibrating_study.h"

#include <string>

namespace alltact {

/// SVG (study_plot.h): depth error over frame time, both linear from 0. The front is a staircase: a
/// dot for the median, a whisker for 95 %, names below (seven at most, the base always). Presses
/// left out have their own marks; dominated rows are grey. A line marks 33.3 ms (30 frames a
/// second), an arrow where it lies outside.
[[nodiscard]] std::string svg_of(const AccuracyStudy& study);

/// The same for a calibration, over the total minutes of technician and computer.
[[nodiscard]] std::string svg_of(const CalibratingStudy& study);

}  // namespace alltact
