// What typical faults look like: a chapter of reports.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "widgets/report/document.h"

#include <QFont>
#include <QPalette>

namespace alltact {

/// Every picture is a calibration that the program simulates here and now, with the fault and
/// nothing else. About a second. Error: the job was stopped.
[[nodiscard]] Status add_typical_faults(Document& document,
                                        const QPalette& palette,
                                        const QFont& font,
                                        const Job& job);

}  // namespace alltact
