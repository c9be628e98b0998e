// Studies as pictures.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/calibrating_study.h"

#include <string>

namespace alltact {

/// SVG (study_plot.h): error of depth over the time of a frame, both linear from 0. The front as a
/// staircase with the median as a dot and a whisker to where 95 % lie within, named in words below
/// (seven at most, the base always), presses left out marked apart; what is dominated grey; a line
/// at 33.3 ms, where 30 pictures a second end, or where it lies.
[[nodiscard]] std::string svg_of(const AccuracyStudy& study);

/// The same of a calibration, over minutes of hand and computing together.
[[nodiscard]] std::string svg_of(const CalibratingStudy& study);

}  // namespace alltact
