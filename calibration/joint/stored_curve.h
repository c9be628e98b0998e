// A fitted curve as the finger keeps it.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press_samples.h"

namespace alltact {

/// What is stored of a fitted curve; `part`: the face that its variation is of.
[[nodiscard]] MappingParameters mapping_parameters(const MappingCurve& curve,
                                                   MappingAlong along,
                                                   const PressedPart& part = {});

/// Whether a fitted curve is a mapping: increasing over its whole domain.
[[nodiscard]] bool increases(const MappingCurve& curve, MappingAlong along);

}  // namespace alltact
