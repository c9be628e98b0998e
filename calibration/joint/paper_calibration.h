// The source paper's calibration: each press's circle searched separately, then one cubic without
// constant through all of them.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/finger/finger.h"
#include "core/job.h"

#include <vector>

namespace alltact {

/// `presses` must be measured by the paper's own steps (PaperMethod); otherwise the results mix two
/// methods. Presses whose circle cannot be found are left out with their reason. Errors: no press
/// with a circle, no increasing curve.
[[nodiscard]] Result<Calibration> calibrate_as_paper(const std::vector<Press>& presses,
                                                     const Camera& camera,
                                                     const Face& face,
                                                     const Job& job);

}  // namespace alltact
