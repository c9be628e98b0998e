// One stack of steps for the open finger: its source can be taken back like everything else.
#include "app/studio/main_window.h"
#include "core/open/open_source.h"
#include "tests/studio/calibrate_rig.h"

#include <QAction>
#include <QCheckBox>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using Inputs = std::vector<std::filesystem::path>;

void undo(Studio& studio) { QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier); }
void redo(Studio& studio) {
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
}

bool wait_for_finger(Studio& studio, const std::filesystem::path& folder) {
  return wait_until([&] {
    const FingerStatus& finger = studio.session().status().finger;
    return finger.folder == folder && finger.state == FingerState::kReady;
  });
}

bool wait_for_source(Studio& studio, const std::filesystem::path& source) {
  return wait_until([&] {
    return studio.session().status().source.inputs == Inputs{source} &&
           studio.session().view() != nullptr;
  });
}

StudioOptions calibrated() {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().bending()};
  return options;
}

TEST(Undo, OpeningAFingerIsNoStepAndForgetsThoseOnTheOneBefore) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_finger(studio, made.calibrated()));
  auto* markers = studio.find<QCheckBox>("Markers with numbers");
  QTest::mouseClick(markers, Qt::LeftButton, {}, {8, markers->height() / 2});
  ASSERT_TRUE(studio.window().undo_stack().canUndo());
  studio.window().open_finger(made.described());
  ASSERT_TRUE(wait_for_finger(studio, made.described()));
  EXPECT_FALSE(studio.window().undo_stack().canUndo());
  undo(studio);
  QTest::qWait(100);
  EXPECT_EQ(studio.session().status().finger.folder, made.described());
  studio.window().open_finger({});
  ASSERT_TRUE(wait_for_finger(studio, {}));  // the scene's own
  EXPECT_FALSE(studio.window().undo_stack().canUndo());
}

/// On the page Presses, right after a finger was opened there.
TEST(Undo, TakesBackAChangeOfPressesAndNeverTheFinger) {
  CalibrateStudio rig(2);
  rig.open();
  const auto folder = rig.studio().session().status().finger.folder;
  rig.studio().window().open_finger(MadeFingers::get().described());
  ASSERT_TRUE(wait_for_finger(rig.studio(), MadeFingers::get().described()));
  rig.studio().window().open_finger(folder);
  ASSERT_TRUE(wait_for_finger(rig.studio(), folder));
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(2));
  undo(rig.studio());
  EXPECT_EQ(rig.collection().press_set().ball_radius_mm, 0);
  undo(rig.studio());
  QTest::qWait(100);
  EXPECT_EQ(rig.studio().session().status().finger.folder, folder);
}

TEST(Undo, TakesBackTheSourceThatWasChosen) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  studio.window().open_source({made.touched()});
  ASSERT_TRUE(wait_for_source(studio, made.touched()));
  EXPECT_EQ(studio.window().undo_stack().undoText(), "open source touched.yaml");
  undo(studio);
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  redo(studio);
  EXPECT_TRUE(wait_for_source(studio, made.touched()));
}

TEST(Undo, LeadsBackToTheFirstPage) {
  Studio studio;
  studio.click("Simulated finger");
  ASSERT_TRUE(studio.wait_for_picture());
  undo(studio);
  EXPECT_TRUE(
      wait_until([&] { return studio.session().status().source.state == SourceState::kClosed; }));
  EXPECT_TRUE(wait_until([&] {
    const auto buttons = studio.window().findChildren<QPushButton*>();
    return std::any_of(buttons.begin(), buttons.end(), [](const QPushButton* button) {
      return button->isVisible() && button->text() == QLatin1String("&Simulated finger");
    });
  }));
  EXPECT_NE(studio.find<QToolButton>("Source: none"), nullptr);
}

/// The menu's line that undoes.
QString undo_line(Studio& studio) {
  for (QMenu* menu : studio.window().findChildren<QMenu*>())
    for (const QAction* action : menu->actions())
      if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Z)) return action->text();
  return {};
}

TEST(Undo, SaysWhatWasDoneInTheLanguageOfNow) {
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_finger(studio, MadeFingers::get().calibrated()));
  studio.window().open_source({MadeFingers::get().touched()});
  EXPECT_TRUE(undo_line(studio).endsWith("open source touched.yaml"))
      << undo_line(studio).toStdString();
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("de")});
  EXPECT_TRUE(wait_until([&] { return undo_line(studio).endsWith("Quelle touched.yaml öffnen"); }))
      << undo_line(studio).toStdString();
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  EXPECT_TRUE(wait_until([&] { return undo_line(studio).endsWith("open source touched.yaml"); }));
}

TEST(Undo, OpeningWhatIsOpenIsNoStep) {
  Studio studio(calibrated());
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().open_source({MadeFingers::get().bending()});
  studio.window().open_finger(MadeFingers::get().calibrated());
  EXPECT_FALSE(studio.window().undo_stack().canUndo());
}

TEST(Undo, GoesBackInTheOrderOfWhatWasDone) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  auto* markers = studio.find<QCheckBox>("Markers with numbers");
  QTest::mouseClick(markers, Qt::LeftButton, {}, {8, markers->height() / 2});
  studio.window().open_source({made.touched()});
  ASSERT_TRUE(wait_for_source(studio, made.touched()));
  undo(studio);
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  EXPECT_FALSE(markers->isChecked());
  undo(studio);
  EXPECT_TRUE(markers->isChecked());
  EXPECT_FALSE(studio.window().undo_stack().canUndo());
}

TEST(Undo, GivesTheCameraThatComesBackWhatItHadBefore) {
  FakeCamera fake({});
  StudioOptions options;
  options.opener = with_camera(fake);
  options.source = {"camera"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return studio.session().status().controller.is_locked; }));
  QTest::keyClick(studio.find<QCheckBox>("Lock brightness"), Qt::Key_Space);
  auto* exposure = studio.find<QSlider>("Exposure time");
  ASSERT_TRUE(wait_until([&] { return exposure->isEnabled(); }));
  const int before = fake.control(V4L2_CID_EXPOSURE_ABSOLUTE);
  QTest::keyClick(exposure, Qt::Key_Right);
  ASSERT_TRUE(wait_until([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == before + 1; }));
  studio.window().open_source({MadeFingers::get().bending()});
  ASSERT_TRUE(wait_for_source(studio, MadeFingers::get().bending()));
  undo(studio);
  undo(studio);  // at once: the camera is still being opened
  EXPECT_TRUE(wait_for_source(studio, "camera"));
  EXPECT_TRUE(wait_until([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == before; }));
}

TEST(Undo, NeverEndsARecording) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  studio.window().open_source({made.touched()});
  ASSERT_TRUE(wait_for_source(studio, made.touched()));
  studio.session().start_recording(studio.folder() / "a.mkv");
  const auto& recording = studio.session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 2; }));
  undo(studio);
  EXPECT_EQ(recording.state, RecordingState::kRunning);
  EXPECT_EQ(studio.session().status().source.inputs, Inputs{made.touched()});
  studio.session().stop_recording();
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  undo(studio);
  EXPECT_TRUE(wait_for_source(studio, made.bending()));
}

TEST(Undo, TakesBackGoingOnWithTheLastSessionInOneStep) {
  const auto& made = MadeFingers::get();
  const TemporaryFolder folder;
  StudioOptions options;
  options.session_folder = folder / "session";
  SessionState kept;
  kept.finger = made.calibrated();
  kept.source = {made.bending()};
  { SessionStore(options.session_folder).keep(kept); }
  Studio studio(options);
  studio.click("Go on with finger calibrated, source bending.yaml");
  ASSERT_TRUE(wait_for_source(studio, made.bending()));
  EXPECT_EQ(studio.window().undo_stack().count(), 1);
  undo(studio);
  EXPECT_TRUE(wait_until([&] {
    return studio.session().status().finger.folder == made.calibrated() &&
           studio.session().status().source.state == SourceState::kClosed;
  }));
}

}  // namespace
}  // namespace alltact::test
