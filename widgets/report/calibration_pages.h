// The report of a calibration, for the lab book: what it is worth, and how one can see that.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// calibration_report.html and calibration_report.pdf of the finger in `folder`, the same bytes for
/// the same calibration. Needs a QApplication, on any platform, and the thread it lives in.
/// Errors: the job was stopped; the printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_calibration_pages(
    const FingerCalibration& done, const std::filesystem::path& folder, const Job& job);

}  // namespace alltact
