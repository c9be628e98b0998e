// Nothing moves under the mouse: every control that stays visible stays where it is while notices,
// messages and results come and go; and what stands above a page is low.
#include "app/studio/onboarding.h"
#include "app/studio/window_bars.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/calibrating/check_page.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/pages/inspect_page.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QMenuBar>
#include <QPointer>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr int kMostAbovePage_px = 90;

std::string described(const QWidget& widget) {
  const QString name = widget.accessibleName().isEmpty() ? widget.property("text").toString()
                                                         : widget.accessibleName();
  return fmt::format("{} \"{}\"", widget.metaObject()->className(), name.toStdString());
}

std::string rect_text(const QRect& rect) {
  return fmt::format("({}, {}) {} x {}", rect.x(), rect.y(), rect.width(), rect.height());
}

/// Where each control of a window is that is in view.
class Controls {
 public:
  explicit Controls(QWidget& window) : window_(window) { remember(); }
  /// Fails for each that is still visible and has moved; then remembers anew.
  void expect_unmoved(const std::string& after) {
    QTest::qWait(60);  // layouts follow with the next turns of the loop
    for (const auto& [widget, before] : known_)
      if (widget && widget->isVisible() && rect_of(*widget) != before)
        ADD_FAILURE() << after << ": " << described(*widget) << " was at " << rect_text(before)
                      << ", is at " << rect_text(rect_of(*widget)) << texts();
    remember();
  }
  /// Of the messages that come and go.
  std::string texts() const {
    std::string all;
    for (const auto* text : window_.findChildren<ReservedText*>())
      if (text->isVisible())
        all += fmt::format("\n  {}: {}", rect_text(rect_of(*text)), text->text().toStdString());
    return all;
  }
  void remember() {
    known_.clear();
    for (auto* widget : window_.findChildren<QWidget*>())
      if (widget->isVisible() && !widget->visibleRegion().isEmpty() &&
          widget->window() == &window_ && is_control(*widget))
        known_.emplace_back(widget, rect_of(*widget));
  }

 private:
  static bool is_control(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) ||
           qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QAbstractSpinBox*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) ||
           qobject_cast<const QAbstractItemView*>(&widget) ||
           qobject_cast<const ImagePanel*>(&widget) || qobject_cast<const ImageView*>(&widget);
  }
  QRect rect_of(const QWidget& widget) const {
    return {widget.mapTo(&window_, QPoint()), widget.size()};
  }
  QWidget& window_;
  std::vector<std::pair<QPointer<QWidget>, QRect>> known_;
};

void click(Studio& studio, const QString& name) {
  auto* button = studio.find<QAbstractButton>(name);
  if (button != nullptr) QTest::mouseClick(button, Qt::LeftButton);
}

TEST(Steady, NoPageMovesWhenANoticeComesUnfoldsAndGoes) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }));
  auto* bar = studio.window().findChild<NotificationBar*>();
  for (const char* page : {"live", "calibrate", "record", "inspect", "accuracy"}) {
    studio.window().go_to(page);
    QTest::qWait(300);
    Controls controls(studio.window());
    const std::string at = page;
    bar->show_error(
        Error{en::say("the file cannot be read"), std::string("a.yaml"),
              en::say("another file, whose name shows what it holds, in a folder that this "
                      "computer can read at any time, such as one of its own disk, or the "
                      "same file again once its disk is plugged in")});
    controls.expect_unmoved(at + ", a notice came");
    click(studio, "Show all in full");
    controls.expect_unmoved(at + ", all are shown in full");
    click(studio, "Show only the newest");
    controls.expect_unmoved(at + ", only the newest is shown");
    for (auto* button : bar->findChildren<QToolButton*>())
      if (button->isVisible() && button->accessibleName().startsWith("Dismiss: ")) button->click();
    controls.expect_unmoved(at + ", all were dismissed");
    studio.window().open_source({MadeFingers::get().touched()});  // forgets the error
    ASSERT_TRUE(studio.wait_for_picture());
    QTest::qWait(300);
  }
}

TEST(Steady, PressesStayWhereTheyAreWhileTheyAreTakenAndChosen) {
  CalibrateStudio rig;
  rig.hold_still();
  rig.open();
  Studio& studio = rig.studio();
  rig.go_to_step("Presses");
  QTest::qWait(200);
  Controls controls(studio.window());
  rig.type_radius("4");
  controls.expect_unmoved("the radius");
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(rig.wait_for_press());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    controls.expect_unmoved(fmt::format("Space {}", i));
    ASSERT_TRUE(rig.wait_until_looked_at(i));
    controls.expect_unmoved(fmt::format("press {}", i));
  }
  ASSERT_TRUE(wait_until([&] { return rig.place().forecast().result() != nullptr; }, 60000));
  controls.expect_unmoved("the forecast");
  auto* automatic = studio.find<QCheckBox>("Automatically when still");
  automatic->click();
  QTest::qWait(300);
  controls.expect_unmoved("automatic taking");
  automatic->click();
  auto* list = studio.find<QListView>("Presses");
  list->setCurrentIndex(list->model()->index(0, 0));
  controls.expect_unmoved("a press is chosen");
  list->setCurrentIndex(list->model()->index(1, 0));
  controls.expect_unmoved("another press is chosen");
  studio.click("Leave out");
  controls.expect_unmoved("it is left out");
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  controls.expect_unmoved("undone");
}

TEST(Steady, CalibratingAndCheckingMoveNothing) {
  CalibrateStudio rig(4);
  rig.hold_still();
  rig.open();
  Studio& studio = rig.studio();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(4));
  rig.go_to_step("Mapping");
  QTest::qWait(100);
  Controls controls(studio.window());
  studio.click("Calibrate now");
  controls.expect_unmoved("it begins");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  controls.expect_unmoved("it is calibrated");
  rig.go_to_step("Check");
  ASSERT_TRUE(rig.wait_for_depth());
  QTest::qWait(100);
  controls.remember();
  const auto* check = rig.place().findChild<CheckPage*>();
  for (const auto& [count, from_mm, to_mm] : kCheckedAt) {
    ASSERT_TRUE(rig.wait_for_press(from_mm, to_mm));
    studio.click("Take a press (Space)");
    controls.expect_unmoved("a press for the check is requested");
    ASSERT_TRUE(wait_until([&, words = count] { return says(studio, words); })) << count;
    controls.expect_unmoved(count);
  }
  studio.click("Check now");
  controls.expect_unmoved("the check runs");
  ASSERT_TRUE(wait_until([&] { return check->state() != StepState::kToDo; }, 60000));
  controls.expect_unmoved("checked");
}

TEST(Steady, RecordingMovesNothing) {
  StudioOptions options;
  options.finger = MadeFingers::get().described();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  ASSERT_TRUE(wait_until([&] { return says(studio, "Space left"); }));
  QTest::qWait(300);
  studio.find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((studio.folder() / "a.mkv").string()));
  Controls controls(studio.window());
  studio.click("Start recording");
  controls.expect_unmoved("it begins");
  const auto& recording = studio.session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 5; }));
  controls.expect_unmoved("it runs");
  studio.click("Stop recording");
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  controls.expect_unmoved("it is done");
  studio.click("Keep for later");
  controls.expect_unmoved("it is saved for later");
}

TEST(Steady, RecordingAMeasurementMovesNothing) {
  StudioOptions options;
  options.finger = MadeFingers::get().described();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  ASSERT_TRUE(wait_until([&] { return says(studio, "Space left"); }));
  QTest::qWait(300);
  Controls controls(studio.window());
  studio.find<QComboBox>("What the recording is for")->setCurrentIndex(1);
  controls.expect_unmoved("a measurement is chosen");
  studio.find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((studio.folder() / "a.mkv").string()));
  studio.click("Start recording");
  controls.expect_unmoved("it begins");
  const auto& recording = studio.session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 5; }));
  controls.expect_unmoved("it runs");
  studio.click("Stop recording");
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  controls.expect_unmoved("it is done");
}

TEST(Steady, JudgingAndInstallingMoveNothing) {
  const TemporaryFolder folder;
  std::filesystem::copy(MadeFingers::get().described(), folder / "finger",
                        std::filesystem::copy_options::recursive);
  StudioOptions options;
  options.finger = folder / "finger";
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  ASSERT_TRUE(wait_until([&] { return says(studio, "Space left"); }));
  studio.find<QLineEdit>("Recording file")
      ->setText(QString::fromStdString((studio.folder() / "a.mkv").string()));
  studio.click("Start recording");
  const auto& recording = studio.session().status().recording;
  ASSERT_TRUE(wait_until([&] { return recording.counts.recorded > 30; }));
  studio.click("Stop recording");
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  QTest::qWait(100);
  Controls controls(studio.window());
  ASSERT_TRUE(wait_until([&] { return says(studio, "Expected error"); }));
  controls.expect_unmoved("it is judged");
  int highest = 0;
  const auto* bar = studio.window().findChild<QProgressBar*>("progress_of_installation");
  ASSERT_NE(bar, nullptr);
  QObject::connect(bar, &QProgressBar::valueChanged, bar, [&](int value) {
    EXPECT_TRUE(value == 0 || value >= highest) << "the bar goes back";
    highest = value;
  });
  studio.click("Install as this finger's reference");
  controls.expect_unmoved("it is being installed");
  ASSERT_TRUE(wait_until([&] { return says(studio, "Installed."); }));
  controls.expect_unmoved("it is installed");
}

TEST(Steady, MeasuringContactsAndALoadedFingerMoveNothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "pressing.yaml", pressing_scene()).ok());
  StudioOptions options;
  options.source = {folder / "pressing.yaml"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  QTest::qWait(300);
  Controls controls(studio.window());
  studio.window().open_finger(MadeFingers::get().calibrated());
  controls.expect_unmoved("the finger is being loaded");
  ASSERT_TRUE(wait_until([&] {
    const auto view = studio.session().view();
    return view && view->depth_layer;
  }));
  controls.expect_unmoved("it is loaded");
  for (int times = 0; times < 4; ++times) {
    QTest::qWait(500);  // a press, or the next one
    controls.expect_unmoved("it measures");
  }
}

TEST(Steady, InspectingMovesNothing) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().resize(1280, 1400);  // the focus scrolls nothing
  studio.window().go_to("inspect");
  auto& page = *studio.window().findChild<InspectPage*>();
  page.open(MadeFingers::get().touched_pictures());
  const auto measured = [&](std::size_t number) {
    return wait_until([&] {
      const auto& frame = page.inspection().frame();
      return frame && frame->surface && frame->number == number;
    });
  };
  ASSERT_TRUE(measured(0));
  QTest::qWait(300);
  Controls controls(studio.window());
  QTest::keyClick(studio.find<QSpinBox>("Current frame"), Qt::Key_Up);
  ASSERT_TRUE(measured(1));
  controls.expect_unmoved("another frame");
  studio.click("Deepest");
  controls.expect_unmoved("a point is set");
  studio.click("Along");
  controls.expect_unmoved("a line is set");
  studio.click("Clear");
  controls.expect_unmoved("the points are cleared");
}

TEST(Steady, WhatStandsAboveAPageIsLow) {
  Studio studio;
  studio.click("Try with a simulated finger");
  auto* guide = studio.window().findChild<Tutorial*>();
  ASSERT_TRUE(wait_until([&] { return guide->step() == Tutorial::Step::kRecord; }));
  auto* bar = studio.window().findChild<NotificationBar*>();
  bar->show_error(Error{en::say("the file cannot be read"), std::string("a.yaml"), ""});
  for (const char* name : {"live", "calibrate", "record", "inspect", "accuracy"}) {
    studio.window().go_to(name);
    QTest::qWait(60);
    EXPECT_TRUE(guide->isVisible() && bar->isVisible()) << name;
    for (const Page* page : studio.window().findChildren<Page*>()) {
      if (!page->isVisible()) continue;
      const int above_px = page->mapTo(&studio.window(), QPoint()).y() -
                           studio.window().menuBar()->geometry().bottom();
      EXPECT_LE(above_px, kMostAbovePage_px) << name;
    }
  }
}

/// Of header, notices, guide and page only one leads to what comes next.
TEST(Steady, OneButtonLeadsOnward) {
  Studio studio;
  const auto expect_one = [&](const char* lead, const std::string& when) {
    QTest::qWait(100);
    QStringList found;
    for (const auto* button : studio.window().findChildren<QAbstractButton*>())
      if (button->isVisible() && button->text().remove(QLatin1Char('&')) == QLatin1String(lead))
        found << QString::fromStdString(described(*button));
    EXPECT_EQ(found.size(), 1) << when << ": " << found.join(", ").toStdString();
  };
  studio.window().open_source({MadeFingers::get().bending()});
  studio.window().open_finger(MadeFingers::get().described());
  ASSERT_TRUE(
      wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; }));
  ASSERT_TRUE(wait_until([&] {
    const auto* summary = studio.window().findChild<QPushButton*>("due");
    return summary != nullptr && summary->isVisible();
  }));
  expect_one("Go to Record", "live");
  studio.window().go_to("inspect");
  expect_one("Go to Record", "inspect");
  studio.window().lead_to("calibrate");
  expect_one("Go to Record", "calibrate");
}

}  // namespace
}  // namespace alltact::test
