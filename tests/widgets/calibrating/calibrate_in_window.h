// Calibrates as the window does.
#pragma once

#include "widgets/calibrating/calibration_run.h"

#include <QTest>
#include <QUndoStack>

#include <gtest/gtest.h>

namespace alltact::test {

/// Starts a calibration and waits until it and its report are done.
inline void calibrate_and_wait(CalibrationRun& run, const QUndoStack& undo) {
  const int steps = undo.count();
  run.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !run.is_running() && undo.count() > steps; }, 120000))
      << (run.problem() ? run.problem()->sentence() : "");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !run.is_writing_report(); }, 120000));
}

}  // namespace alltact::test
