// What typical faults look like: a chapter of reports.
#pragma once

#include "calibration/report/typical_faults.h"
#include "core/job.h"
#include "core/result.h"
#include "widgets/report/document.h"

#include <QFont>
#include <QPalette>
#include <vector>

namespace alltact {

/// The example calibrations, each simulated at the call with one fault. About a second; any thread.
/// Error: the job was stopped.
[[nodiscard]] Result<std::vector<SimulatedCalibration>> simulate_typical_faults(const Job& job);

/// Adds the chapter about them.
void add_typical_faults(Document& document,
                        const std::vector<SimulatedCalibration>& faults,
                        const QPalette& palette,
                        const QFont& font);

}  // namespace alltact
