// How far out each contact is believed: the zone, as a part of the contact's radius.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"
#include "core/message.h"

namespace alltact {

/// Fits as much of each contact as ball and lift-off explain, from the rim inwards, by the family
/// of layers; leaves in `options` which part that is, and in `remark` a sentence of it. The inner
/// part alone leaves an offset between balls and mapping open, which a curve that is not quite the
/// layer's then fills; near the rim the offset is seen. The rim itself tells how far the skin
/// follows the ball, but not in which form it comes back. Where rings show that the skin does there
/// what lift_off.h does not know, its error would be taken up by the scale, ten times larger.
[[nodiscard]] JointFit choose_zone(
    const ChoiceInput& input, JointFit fit, JointOptions* options, Message* remark, const Job& job);

}  // namespace alltact
