// What the place Calibrate tells while somebody works at it: where to press, what a ball's place
// means, what the presses come to, what no longer holds.
#include "calibration/checks/check_history.h"
#include "core/base/atomic_file.h"
#include "core/finger/finger_store.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/calibrating/verdict_page.h"

#include <QThread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void open_presses(CalibrateStudio& rig, int count) {
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(count));
}

void calibrate(CalibrateStudio& rig, int count) {
  open_presses(rig, count);
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  ASSERT_TRUE(wait_until([&] { return rig.run().state() == CalibrationState::kCurrent; }));
}

bool wait_for_forecast(CalibrateStudio& rig) {
  return wait_until([&] { return rig.place().forecast().result() != nullptr; }, 60000);
}

std::string label_text(Studio& studio, const QString& label) {
  const auto* found = studio.find<QLabel>(label);
  return found == nullptr ? std::string() : found->text().toStdString();
}

TEST(CalibrateGuide, WhatIsForecastIsWhatCalibratingGives) {
  CalibrateStudio rig(4);
  open_presses(rig, 4);
  ASSERT_TRUE(wait_for_forecast(rig));
  const double foretold_mm = rig.place().forecast().result()->verdict.error_mm;
  EXPECT_TRUE(says(rig.studio(), "With the current presses: "));
  rig.go_to_step("Mapping");
  rig.studio().click("Calibrate now");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  EXPECT_EQ(rig.run().result()->verdict.error_mm, foretold_mm);
  ASSERT_TRUE(wait_until([&] { return rig.place().forecast().result() == nullptr; }))
      << "nothing has changed since";
  // Leaving one out changes the error at once, beside the one in use.
  rig.go_to_step("Presses");
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(0, 0));
  const QString worst = list->model()->index(0, 0).data(PressModel::kName).toString();
  rig.studio().click("Leave out");
  ASSERT_TRUE(wait_for_forecast(rig));
  EXPECT_EQ(rig.place().forecast().result()->calibration.balls.size(), 3U);
  EXPECT_TRUE(says(rig.studio(), "(in use: "));
  // One click back.
  EXPECT_NE(rig.studio().find<QToolButton>("Undo: leave out " + worst), nullptr);
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return rig.place().forecast().result() == nullptr; }));
  EXPECT_FALSE(says(rig.studio(), "(in use: "));
}

TEST(CalibrateGuide, DraggingShowsAtOnceWhatTheBallsPlaceMeans) {
  CalibrateStudio rig(3);
  open_presses(rig, 3);
  ASSERT_TRUE(wait_for_forecast(rig));
  auto* list = rig.studio().find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(0, 0));
  const std::string before = label_text(rig.studio(), "Mapping minus ball in this press");
  EXPECT_THAT(before, HasSubstr("ball here:"));
  EXPECT_THAT(before, testing::Not(HasSubstr("at the calibrated position")));
  auto* editor = rig.studio().find<OutlineEditor>("Image with the ball's outline");
  editor->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(editor, Qt::Key_Right, Qt::ShiftModifier);
  const std::string after = label_text(rig.studio(), "Mapping minus ball in this press");
  EXPECT_THAT(after, HasSubstr("at the calibrated position"));
  EXPECT_NE(before, after);
}

TEST(CalibrateGuide, TheLivePictureSaysWhereToPressAndHowDeepItIs) {
  CalibrateStudio rig;
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_for_press());
  ASSERT_TRUE(wait_until([&] {
    return label_text(rig.studio(), "Next press position").find(", now ") != std::string::npos;
  }));
  EXPECT_THAT(label_text(rig.studio(), "Next press position"),
              HasSubstr("Press here, 0.8 mm deep"));
  // A press that was clicked needs no other click: Space is the pedal, whatever was used last.
  QTest::mouseClick(rig.studio().find<QPushButton>("Live image"), Qt::LeftButton);
  rig.studio().find<QPushButton>("Live image")->setFocus(Qt::MouseFocusReason);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  ASSERT_TRUE(rig.wait_until_looked_at(1));
  const auto says_taken = [&] {
    return says(rig.studio(), "press_01 is taken: ") ||
           says(rig.studio(), "press_01 comes from a single image");
  };
  EXPECT_TRUE(says_taken());
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(says_taken()) << "it is not there any more";
}

TEST(CalibrateGuide, APressThatCannotBeWrittenIsNotSaidToBeTaken) {
  CalibrateStudio rig;
  must(write_file_atomically(rig.finger() / "presses", "no folder"));
  rig.open();
  rig.go_to_step("Presses");
  if (!rig.collection().analyser()) GTEST_SKIP() << "such a finger cannot be looked at";
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_for_press());
  rig.studio().click("Take a press (Space)");
  ASSERT_TRUE(wait_until([&] { return !rig.collection().is_saved("press_01"); }));
  ASSERT_TRUE(wait_until([&] { return !rig.studio().problems().empty(); }));
  EXPECT_TRUE(wait_until(
      [&] {
        return !says(rig.studio(), "is taken: ") &&
               !says(rig.studio(), "comes from a single image");
      },
      2000));
  auto* list = rig.studio().find<QListView>("Presses");
  EXPECT_THAT(list->model()->index(0, 0).data().toString().toStdString(),
              HasSubstr("not saved to disk"));
  // Another finger has nothing to do with it.
  rig.studio().window().open_finger(MadeFingers::get().calibrated());
  EXPECT_TRUE(wait_until([&] { return rig.studio().problems().empty(); }))
      << rig.studio().problems();
}

TEST(CalibrateGuide, ACheckIsOfItsOwnCalibration) {
  CalibrateStudio rig(4);
  open_presses(rig, 4);
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  CheckEntry check;
  check.time = "2026-01-31T12:00:00Z";
  check.verdict = CheckVerdict::kPass;
  check.error_mm = 0.01;
  check.drifting_above_mm = 0.03;
  check.recalibrate_above_mm = 0.06;
  check.presses = 3;
  check.ball_radius_mm = 4;
  check.calibration_date = rig.run().finger()->finger.provenance.at("calibration_date");
  must(append_check(rig.finger(), check));
  rig.close();
  rig.open();
  ASSERT_TRUE(wait_until([&] { return rig.place().is_checked(); }, 20000));
  rig.go_to_step("Check");
  EXPECT_TRUE(says(rig.studio(), "Pass"));
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.collection().leave_out("press_02", "");
  QTest::qWait(1100);  // dates tell seconds
  rig.run().start();
  ASSERT_TRUE(wait_until(
      [&] {
        return rig.run().result() && rig.run().result()->calibration.balls.size() == 3 &&
               !rig.run().is_running();
      },
      60000));
  // What stands on a mapping cannot be used while another is made: the window went back to it.
  rig.go_to_step("Check");
  EXPECT_TRUE(wait_until([&] { return says(rig.studio(), "Not checked yet"); }));
  EXPECT_TRUE(says(rig.studio(), "tested an earlier calibration"));
  EXPECT_FALSE(rig.place().is_checked());
}

TEST(CalibrateGuide, SizesCanBeChangedAfterwardsAndTheMappingIsOldThen) {
  CalibrateStudio rig(3);
  ASSERT_NO_FATAL_FAILURE(calibrate(rig, 3));
  rig.go_to_step("Finger");
  auto* width = rig.studio().find<QDoubleSpinBox>("Width of the face");
  ASSERT_NE(width, nullptr);
  EXPECT_EQ(width->value(), 24);
  EXPECT_FALSE(rig.studio().find<QPushButton>("Change")->isEnabled());
  width->setFocus();
  width->selectAll();
  QTest::keyClicks(width, "23.5");
  QTest::keyClick(width, Qt::Key_Return);
  rig.studio().click("Change");
  ASSERT_TRUE(wait_until([&] { return Finger::load(rig.finger()).value().face.width_mm == 23.5; }));
  EXPECT_TRUE(wait_until([&] { return rig.run().state() == CalibrationState::kStale; }, 20000));
  QTest::keyClick(&rig.studio().window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return Finger::load(rig.finger()).value().face.width_mm == 24; }));
  EXPECT_TRUE(wait_until([&] { return rig.run().state() == CalibrationState::kCurrent; }, 20000));
}

TEST(CalibrateGuide, AFingerThatChangesWhileItIsReadIsReadAgain) {
  CalibrateStudio rig(3);
  ASSERT_NO_FATAL_FAILURE(calibrate(rig, 3));
  QTest::qWait(500);  // what follows a calibration has been read
  rig.run().reload();
  QThread::msleep(500);  // read, and not taken: the window's loop stands
  const auto changed = FingerStore::of(rig.finger())->update([](Finger& finger) {
    finger.face.width_mm = 23.5;
    return Status();
  });
  ASSERT_TRUE(changed) << changed.error().sentence();
  EXPECT_TRUE(wait_until([&] { return rig.run().state() == CalibrationState::kStale; }, 20000));
}

TEST(CalibrateGuide, TheVerdictFillsOneSheetOfPaper) {
  CalibrateStudio rig(4);
  open_presses(rig, 4);
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  const Document sheet = verdict_sheet(*rig.run().result(), rig.run().command_line());
  const auto pdf = sheet.pdf("2026-01-31T12:00:00Z");
  ASSERT_TRUE(pdf) << pdf.error().sentence();
  const fs::path file = fs::path(ALLTACT_SCREENS) / "verdict_sheet.pdf";
  fs::create_directories(file.parent_path());
  must(write_file_atomically(file, *pdf));
  const std::string html = sheet.html();
  EXPECT_THAT(html, HasSubstr("press_01"));
  EXPECT_THAT(html, HasSubstr("alltact calibrate"));
  EXPECT_THAT(html,
              HasSubstr(rig.run().result()->verdict.grade == Grade::kGood ? "Good" : "nproven"));
  // One page: its tree tells how many there are.
  EXPECT_THAT(*pdf, HasSubstr("/Count 1"));
  rig.go_to_step("5");
  EXPECT_TRUE(rig.studio().find<QPushButton>("Print…")->isEnabled());
}

}  // namespace
}  // namespace alltact::test
