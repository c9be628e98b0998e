// The report of the paper's experiments: every measured figure next to the paper's.
#pragma once

#include "calibration/experiments/experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "core/result.h"

#include <string>
#include <vector>

namespace alltact {

/// NAME.html and NAME.pdf; the same report gives the same bytes. Needs a QApplication, on any
/// platform, and its thread. Error: the printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_experiment_pages(const ExperimentReport& report,
                                                                    const std::string& name);

}  // namespace alltact
