// A fitted curve as a finger file stores it.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press_samples.h"

namespace alltact {

/// The stored form of a fitted curve; `part`: the area of the face that its variation refers to.
[[nodiscard]] MappingParameters mapping_parameters(const MappingCurve& curve,
                                                   MappingAlong along,
                                                   const PressedArea& part = {});

/// Whether a fitted curve is a mapping: increasing over its entire domain.
[[nodiscard]] bool increases(const MappingCurve& curve, MappingAlong along);

}  // namespace alltact
