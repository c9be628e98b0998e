// One stack of steps for the session: finger and source can be taken back like everything else.
#include "app/studio/main_window.h"
#include "core/open/open_source.h"
#include "tests/studio/studio_rig.h"

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

TEST(Undo, TakesBackTheFingerThatWasChosen) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_finger(studio, made.calibrated()));
  EXPECT_FALSE(studio.window().undo_stack().canUndo());  // what it was started with stays
  studio.window().open_finger(made.described());
  ASSERT_TRUE(wait_for_finger(studio, made.described()));
  EXPECT_EQ(studio.window().undo_stack().undoText(), "open finger described");
  EXPECT_FALSE(studio.session().status().finger.has_reference);
  undo(studio);
  ASSERT_TRUE(wait_for_finger(studio, made.calibrated()));
  EXPECT_TRUE(studio.session().status().finger.has_reference);
  redo(studio);
  EXPECT_TRUE(wait_for_finger(studio, made.described()));
}

TEST(Undo, OpensAFingerAgainThatWasClosed) {
  const auto& made = MadeFingers::get();
  Studio studio(calibrated());
  ASSERT_TRUE(wait_for_finger(studio, made.calibrated()));
  studio.window().open_finger({});
  ASSERT_TRUE(wait_for_finger(studio, {}));  // the scene's own
  EXPECT_EQ(studio.window().undo_stack().undoText(), "close the finger");
  undo(studio);
  EXPECT_TRUE(wait_for_finger(studio, made.calibrated()));
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
  studio.window().open_finger(MadeFingers::get().described());
  EXPECT_TRUE(undo_line(studio).endsWith("open finger described"))
      << undo_line(studio).toStdString();
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("de")});
  EXPECT_TRUE(wait_until([&] { return undo_line(studio).endsWith("Finger described öffnen"); }))
      << undo_line(studio).toStdString();
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  EXPECT_TRUE(wait_until([&] { return undo_line(studio).endsWith("open finger described"); }));
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
  studio.window().open_finger(made.described());
  ASSERT_TRUE(wait_for_finger(studio, made.described()));
  undo(studio);
  ASSERT_TRUE(wait_for_finger(studio, made.calibrated()));
  EXPECT_EQ(studio.session().status().source.inputs, Inputs{made.touched()});
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
    return studio.session().status().finger.state == FingerState::kNone &&
           studio.session().status().source.state == SourceState::kClosed;
  }));
}

}  // namespace
}  // namespace alltact::test
