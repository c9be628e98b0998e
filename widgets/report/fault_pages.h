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

/// The calibrations that are shown, each simulated here and now with its fault and nothing else.
/// About a second; any thread. Error: the job was stopped.
[[nodiscard]] Result<std::vector<SimulatedCalibration>> simulate_typical_faults(const Job& job);

/// The chapter over these.
void add_typical_faults(Document& document,
                        const std::vector<SimulatedCalibration>& faults,
                        const QPalette& palette,
                        const QFont& font);

}  // namespace alltact
