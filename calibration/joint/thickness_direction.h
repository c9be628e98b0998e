// Which thickness of the layer brightness follows: along the normal, along z, or that along z
// projected onto the normal.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"
#include "core/message.h"

namespace alltact {

/// Along which thickness counts, by the presses left out that `family` is fitted without, and a
/// remark where that is not the normal or is not sure. That is what a layer that scatters light
/// does, so it is left only for what chance does not explain: one shallow press on a steep place
/// would else decide, and the depth of all others change with the incline. Where another way is as
/// good, the remark says so: the two place what presses layer_mm tan(incline) apart. For two
/// presses and more.
[[nodiscard]] MappingAlong choose_along(const ChoiceInput& input,
                                        CurveFamily family,
                                        Message* remark,
                                        const Job& job);

}  // namespace alltact
