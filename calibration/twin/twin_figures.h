// Text on a twin's numbers, for people and for its scene.
#pragma once

#include "calibration/twin/twin.h"
#include "calibration/twin/twin_contact.h"
#include "calibration/twin/twin_lamps.h"
#include "calibration/twin/twin_noise.h"

namespace alltact {

/// Fills figures, remarks, and the comments of the scene. The scene's numbers and residuals are
/// final.
void write_figures(const TwinLamps& lamps,
                   const TwinContact& contact,
                   const TwinNoise& noise,
                   Twin& twin);

}  // namespace alltact
