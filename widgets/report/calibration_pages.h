// The report of a calibration, for the lab book: what it is worth, and how one can see that.
#pragma once

#include "calibration/finger/calibration_report.h"
#include "core/job.h"
#include "core/result.h"
#include "widgets/report/document.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// kReportPage and kReportPaper of the finger in `folder`, the same bytes for the same calibration.
/// Needs a QApplication, on any platform, and the thread it lives in. Errors: the job was stopped;
/// the printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_calibration_pages(
    const FingerCalibration& done, const std::filesystem::path& folder, const Job& job);

/// The files of a report that is put together; any thread.
[[nodiscard]] Result<std::vector<ReportFile>> files_of(const Document& report,
                                                       const std::string& date,
                                                       const Job& job);

}  // namespace alltact
