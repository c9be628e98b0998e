// What a calibration is worth on one sheet of paper, in the window's language: to print and to keep
// beside the finger. The whole report is calibration_report.pdf.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "widgets/report/document.h"

namespace alltact {

/// `command`: makes the same calibration in a terminal. GUI thread.
[[nodiscard]] Document verdict_sheet(const FingerCalibration& done, const QString& command);

/// Asks for a printer, or a PDF file, and prints there.
void print_sheet(const Document& sheet, QWidget& parent);

}  // namespace alltact
