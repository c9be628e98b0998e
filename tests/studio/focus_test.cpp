// After every action the focus is on what comes next, and never on Undo, where Space would take
// back what was just done. At most one button is the primary one.
#include "tests/studio/calibrate_rig.h"
#include "widgets/theme.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

void expect_useful_focus(const std::string& after) {
  QTest::qWait(30);
  const QWidget* focused = QApplication::focusWidget();
  ASSERT_NE(focused, nullptr) << after;
  EXPECT_TRUE(focused->isVisible() && focused->isEnabled()) << after;
  for (const QWidget* widget = focused; widget != nullptr; widget = widget->parentWidget())
    EXPECT_EQ(qobject_cast<const UndoBar*>(widget), nullptr) << after << ": it is on Undo";
  QStringList primary;
  for (const auto* button : focused->window()->findChildren<QPushButton*>())
    if (button->isVisible() && is_primary(*button)) primary << button->text();
  EXPECT_LE(primary.size(), 1) << after << ": " << primary.join(", ").toStdString();
}

void expect_focus_on_primary(const std::string& after) {
  ASSERT_NO_FATAL_FAILURE(expect_useful_focus(after));
  const QWidget* focused = QApplication::focusWidget();
  EXPECT_TRUE(is_primary(*focused)) << after << ": it is on " << focused->metaObject()->className()
                                    << " " << focused->property("text").toString().toStdString();
}

TEST(Focus, IsOnWhatComesNextAfterEveryActionOfCalibrating) {
  CalibrateStudio rig;
  rig.hold_still();
  rig.open();
  Studio& studio = rig.studio();
  for (const char* step : {"1", "2", "3"}) {
    rig.go_to_step(QLatin1String(step));
    expect_useful_focus(std::string("step ") + step);
  }
  rig.type_radius("4");
  expect_useful_focus("the radius");
  for (int i = 1; i <= 4; ++i) {
    ASSERT_TRUE(rig.wait_for_press());
    studio.click("Take a press (Space)");
    ASSERT_TRUE(rig.wait_until_looked_at(i));
    expect_useful_focus("a press is taken");
  }
  auto* list = studio.find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(3, 0));
  studio.click("Leave out");
  expect_useful_focus("left out");
  studio.click("Remove");
  expect_focus_on_primary("removed");
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  expect_useful_focus("undone");
  studio.click("Next: Mapping");
  expect_useful_focus("it calibrates");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() && !rig.run().is_running(); }, 60000));
  expect_focus_on_primary("it is calibrated");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  expect_useful_focus("the verdict");
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  QTest::qWait(200);
  expect_useful_focus("the calibration is undone");
}

TEST(Focus, IsOnWhatComesNextAfterACheck) {
  CalibrateStudio rig(4);
  rig.hold_still();
  rig.open();
  Studio& studio = rig.studio();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() && !rig.run().is_running(); }, 60000));
  rig.go_to_step("Check");
  ASSERT_TRUE(rig.wait_for_depth());
  for (const auto& [count, from_mm, to_mm] : kCheckedAt) {
    ASSERT_TRUE(rig.wait_for_press(from_mm, to_mm));
    studio.click("Take a press (Space)");
    ASSERT_TRUE(wait_until([&, words = count] { return says(studio, words); })) << count;
    expect_useful_focus(count);
  }
  studio.click("Check now");
  expect_useful_focus("the check runs");
  ASSERT_TRUE(wait_until(
      [&] {
        return says(studio, "Pass") || says(studio, "Drifting") || says(studio, "Recalibrate");
      },
      60000));
  expect_useful_focus("checked");
}

TEST(Focus, IsUsefulOnEveryPageAndAfterEveryRecording) {
  StudioOptions options;
  options.finger = MadeFingers::get().described();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  for (const char* page : {"live", "calibrate", "inspect", "accuracy", "record"}) {
    studio.window().go_to(page);
    expect_useful_focus(page);
  }
  expect_focus_on_primary("record");
  studio.find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((studio.folder() / "a.mkv").string()));
  studio.click("Start recording");
  expect_focus_on_primary("it records");
  const auto& recording = studio.session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 5; }));
  studio.click("Stop recording");
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  expect_useful_focus("it is done");
  studio.click("Keep for later");
  expect_useful_focus("it is saved for later");
}

}  // namespace
}  // namespace alltact::test
