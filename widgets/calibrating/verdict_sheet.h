// One printable sheet about a calibration, in the window's language, to file with the finger. The
// full report is calibration_report.pdf.
#pragma once

#include "calibration/checks/finger_worth.h"
#include "calibration/finger/calibrate_finger.h"
#include "widgets/report/document.h"

namespace alltact {

/// GUI thread.
///   command: terminal command that makes the same calibration
///   now: rating as of now; nullopt: as of the calibration
[[nodiscard]] Document verdict_sheet(const FingerCalibration& done,
                                     const QString& command,
                                     const std::optional<FingerWorth>& now = std::nullopt);

/// Opens a print dialog for a printer or a PDF file and prints.
void print_sheet(const Document& sheet, QWidget& parent);

}  // namespace alltact
