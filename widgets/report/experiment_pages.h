// The report of the paper's experiments: every figure of ours beside the paper's.
#pragma once

#include "calibration/experiments/experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "core/result.h"

#include <string>
#include <vector>

namespace alltact {

/// NAME.html and NAME.pdf, the same bytes for the same report. Needs a QApplication, on any
/// platform, and the thread it lives in. Error: the printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_experiment_pages(const ExperimentReport& report,
                                                                    const std::string& name);

}  // namespace alltact
