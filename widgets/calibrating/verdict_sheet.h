// What a calibration is worth on one sheet of paper, in the window's language: to print and to keep
// beside the finger. The whole report is calibration_report.pdf.
#pragma once

#include "calibration/checks/finger_worth.h"
#include "calibration/finger/calibrate_finger.h"
#include "widgets/report/document.h"

namespace alltact {

/// GUI thread.
///   command: makes the same calibration in a terminal
///   now: what the finger is worth since; nullopt: as the calibration left it
[[nodiscard]] Document verdict_sheet(const FingerCalibration& done,
                                     const QString& command,
                                     const std::optional<FingerWorth>& now = std::nullopt);

/// Asks for a printer, or a PDF file, and prints there.
void print_sheet(const Document& sheet, QWidget& parent);

}  // namespace alltact
