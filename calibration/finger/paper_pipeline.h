// The source paper's method on a finger calibrated by this program. It takes nothing of the
// mapping, so that the complete methods are compared.
#pragma once

#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/finger/press_set.h"
#include "core/image/frame.h"
#include "core/sensing/paper_method.h"
#include "core/sensing/pipeline.h"

#include <vector>

namespace alltact {

/// Press images measured by the paper's own steps, each by itself. Excluded presses, punches, and
/// images without a face or a reference are omitted. Errors: an image of another size; none is
/// left; stopped.
[[nodiscard]] Result<std::vector<Press>> paper_presses(PaperMethod& method,
                                                       const std::vector<FramePtr>& frames,
                                                       const PressSet& press_set, const Job& job);

/// Measures by the paper's method. The mapping is the finger's where it was calibrated with
/// --method paper; else that method calibrates in memory, from the finger's stored presses. Errors:
/// those of PaperMethod::create and calibrate_as_paper(); a finger without stored presses.
[[nodiscard]] Result<Pipeline> paper_pipeline(const FingerSnapshot& finger, const Job& job);

}  // namespace alltact
