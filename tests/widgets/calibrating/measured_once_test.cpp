// A press is measured once: for the desk, the forecast, the calibration, its report and a check.
#include "calibration/checks/press_check.h"
#include "calibration/finger/calibration_file.h"
#include "tests/support/finger_on_disk.h"
#include "tests/widgets/calibrating/calibrate_in_window.h"

#include <QTest>
#include <QUndoStack>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class MeasuredOnce : public FingerOnDisk {};

TEST_F(MeasuredOnce, FromTheDeskToTheReport) {
  const auto before = press_measurements();
  const auto measured = [&] { return press_measurements() - before; };
  QUndoStack undo;
  PressCollection collection(undo);
  CalibrationRun run(collection, undo, "0.1.0");
  PressForecast forecast(collection, run);
  forecast.set_watched(true);
  collection.open(finger());
  ASSERT_TRUE(QTest::qWaitFor([&] { return collection.is_ready(); }, 30000));
  collection.add_files({flat_.presses[0], flat_.presses[1], flat_.presses[2]});
  collection.set_radius(FlatSensor::kBallRadiusMm);
  ASSERT_TRUE(QTest::qWaitFor([&] { return collection.usable_count() == 3; }, 60000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return forecast.result() != nullptr; }, 60000))
      << (forecast.problem() ? forecast.problem()->sentence() : "");
  EXPECT_EQ(measured(), 3);
  const std::weak_ptr<const Calibration> forecast_solution = forecast.result()->solution;

  ASSERT_NO_FATAL_FAILURE(calibrate_and_wait(run, undo));
  ASSERT_TRUE(run.result()->solution);
  EXPECT_EQ(run.result()->solution, forecast_solution.lock()) << "solved twice";
  EXPECT_EQ(run.result()->calibration.balls.size(), 3U);
  EXPECT_EQ(run.result()->calibration.held_out_mm, forecast.baseline()->calibration.held_out_mm);
  EXPECT_EQ(measured(), 3);
  collection.set_radius(FlatSensor::kBallRadiusMm + 0.01);  // notes are not measured
  ASSERT_NO_FATAL_FAILURE(calibrate_and_wait(run, undo));
  EXPECT_EQ(measured(), 3);
  EXPECT_NE(run.result()->solution, forecast_solution.lock());

  collection.disk()->wait();
  ASSERT_TRUE(stored_calibration(finger()));
  EXPECT_EQ(measured(), 3);
  PressInput presses;
  presses.files = {flat_.presses[3]};
  const auto check = check_with_presses(*open_finger(finger()).value(), presses, {}, Job());
  ASSERT_TRUE(check) << check.error().sentence();
  EXPECT_EQ(measured(), 4) << "the new press alone";
}

}  // namespace
}  // namespace alltact::test
