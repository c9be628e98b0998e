// The report of a calibration for the lab book: its grade and the evidence for it.
#pragma once

#include "calibration/finger/calibration_report.h"
#include "core/job.h"
#include "core/result.h"
#include "widgets/report/document.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// kReportHtml and kReportPdf of the finger in `folder`; the same calibration gives the same
/// bytes. Needs a QApplication, on any platform, and its thread. Errors: the job was stopped; the
/// printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_calibration_pages(
    const FingerCalibration& done, const std::filesystem::path& folder, const Job& job);

/// The files of a finished report; any thread.
[[nodiscard]] Result<std::vector<ReportFile>> files_of(const Document& report,
                                                       const std::string& date,
                                                       const Job& job);

}  // namespace alltact
