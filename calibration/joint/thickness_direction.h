// Which thickness of the layer brightness follows: along the normal, along z, or that along z
// projected onto the normal.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"
#include "core/message.h"

namespace alltact {

/// Chooses the direction of the thickness by the held-out errors of `family`. The default is the
/// normal, as in a layer that scatters light; another direction needs evidence beyond chance.
/// Otherwise one shallow press on a steep face would decide, and all other depths would change with
/// the incline. `remark` reports another direction than the normal, or one that is equally good.
/// The two displace positions on the face by layer_mm tan(incline). For two presses and more.
[[nodiscard]] MappingAlong choose_along(const ChoiceInput& input,
                                        CurveFamily family,
                                        Message* remark,
                                        const Job& job);

}  // namespace alltact
