// The source paper's method on a finger that was calibrated by ours: nothing of its mapping is
// taken, so that what is compared is the whole of both.
#pragma once

#include "calibration/presses/press.h"
#include "core/finger/finger_store.h"
#include "core/finger/press_set.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/paper_method.h"
#include "core/sensing/pipeline.h"

#include <vector>

namespace alltact {

/// Press pictures as the paper's own steps measure them, each by itself. Those that are excluded,
/// punches, and those in which it finds no face or no reference are not among them. Error: a
/// picture of another size; none is left; stopped.
[[nodiscard]] Result<std::vector<Press>> paper_presses(PaperMethod& method,
                                                       const std::vector<FramePtr>& frames,
                                                       const PressSet& said,
                                                       const Job& job);

/// Measures by the paper's method. The mapping is the finger's where it was calibrated with
/// --method paper; else that method calibrates, in memory, from the presses that the finger keeps.
/// Errors: those of PaperMethod::create and calibrate_as_paper(); a finger that keeps no presses.
[[nodiscard]] Result<Pipeline> paper_pipeline(const FingerSnapshot& finger, const Job& job);

}  // namespace alltact
