// A study as a picture.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <string>

namespace alltact {

/// SVG, 900 x 620: error of depth over the time of a frame, both from 0. The front as a staircase
/// with the median as a dot and a whisker to where 95 % lie within, named in words below (seven at
/// most, the base always); what is dominated grey; a line at 33.3 ms, where 30 pictures a second
/// end, if times come near it.
[[nodiscard]] std::string svg_of(const AccuracyStudy& study);

}  // namespace alltact
