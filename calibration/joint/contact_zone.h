// Which zone of each contact the fit reads, as a fraction of the contact's radius.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"
#include "core/message.h"

namespace alltact {

/// Fits as much of each contact as ball and lift-off explain, from the rim inwards, by the family
/// of layers. Stores the zone in `options`, and a sentence on it in `remark`. The inner zone alone
/// leaves an offset between balls and mapping open. A curve that is not quite the layer's takes
/// that offset up; near the rim it shows. The rim shows how far the skin follows the ball, but not
/// the form in which it leaves it. Where rings show a form that lift_off.h does not model, the
/// scale would take up ten times its error.
[[nodiscard]] JointFit choose_zone(
    const ChoiceInput& input, JointFit fit, JointOptions* options, Message* remark, const Job& job);

}  // namespace alltact
