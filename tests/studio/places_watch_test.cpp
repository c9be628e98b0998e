// The places Inspect, Calibrate and Accuracy never hold the event loop, as the whole window does
// not (see whole_test.cpp).
#include "core/open/open_source.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/loop_watch_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/pages/accuracy_page.h"

#include <QComboBox>
#include <QPushButton>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

void inspect(LoopWatch& watch) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  MainWindow& window = studio.window();
  auto& place = *window.findChild<InspectPage*>();
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 30000));
  QTest::qWait(300);
  watch.during(
      "the place", [&] { window.go_to("inspect"); }, 300);
  watch.during(
      "opening a recording", [&] { place.open(MadeFingers::get().touched_pictures()); }, 1000);
  ASSERT_TRUE(wait_until(
      [&] { return place.inspection().frame() && place.inspection().frame()->surface; }, 30000));
  watch.during(
      "playing", [&] { window.findChild<TimeLine*>()->play(true); }, 1000);
  watch.during(
      "a profile", [&] { place.findChild<QPushButton*>(QStringLiteral("across"))->click(); }, 300);
  auto* comparison = place.findChild<QComboBox*>(QStringLiteral("comparison"));
  watch.during(
      "another method", [&] { QTest::keyClick(comparison, Qt::Key_Down); }, 1000);
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame()->other.has_value(); }, 30000));
  watch.during(
      "the difference", [&] { QTest::keyClick(comparison, Qt::Key_Down); }, 500);
  watch.during(
      "undo", [&] { window.undo_stack().undo(); }, 500);
  watch.during(
      "a second finger",
      [&] {
        place.open_second(
            SecondFinger{MadeFingers::get().calibrated(), MadeFingers::get().touched_pictures()});
      },
      1000);
  ASSERT_TRUE(wait_until([&] { return place.pair().frames().has_value(); }, 30000));
  const TemporaryFolder out;
  watch.during(
      "saving a mesh", [&] { place.save(out / "a.ply"); }, 500);
  ASSERT_TRUE(wait_until([&] { return !place.is_saving(); }, 30000));
  watch.during(
      "the live finger",
      [&] {
        studio.click(QStringLiteral("Live finger"));
        window.open_source({MadeFingers::get().touched()});
      },
      1000);
}

void accuracy(LoopWatch& watch) {
  StudioOptions options;
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  MainWindow& window = studio.window();
  auto& place = *window.findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return place.run().study() != nullptr; }, 30000));
  watch.during(
      "the place", [&] { window.go_to("accuracy"); }, 300);
  watch.during(
      "the next setting", [&] { QTest::keyClick(&place.plot(), Qt::Key_Left); }, 300);
  watch.during(
      "using it", [&] { QTest::keyClick(&place.plot(), Qt::Key_Return); }, 1000);
  watch.during(
      "undo", [&] { window.undo_stack().undo(); }, 1000);
}

void calibrate(LoopWatch& watch) {
  CalibrateStudio rig(3);
  rig.open();
  MainWindow& window = rig.studio().window();
  window.go_to("live");
  QTest::qWait(300);
  watch.during(
      "the place", [&] { window.go_to("calibrate"); }, 500);
  watch.during(
      "the presses", [&] { rig.go_to_step(QStringLiteral("Presses")); }, 500);
  watch.during(
      "the ball's radius", [&] { rig.collection().set_radius(4); }, 300);
  ASSERT_TRUE(rig.wait_until_looked_at(3));
  auto* list = rig.studio().find<QListView>(QStringLiteral("Presses"));
  watch.during(
      "a press", [&] { list->setCurrentIndex(list->model()->index(1, 0)); }, 500);
  watch.during(
      "the mapping", [&] { rig.go_to_step(QStringLiteral("Mapping")); }, 300);
  watch.during(
      "calibrating", [&] { rig.run().start(); }, 1500);
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 120000));
  watch.during(
      "the verdict", [&] { rig.go_to_step(QStringLiteral("5")); }, 500);
  watch.during(
      "the check", [&] { rig.go_to_step(QStringLiteral("6")); }, 500);
  watch.during(
      "undo", [&] { window.undo_stack().undo(); }, 500);
}

TEST(Places, InspectNeverBlocksForMoreThan30Milliseconds) {
  static_cast<void>(MadeFingers::get());
  LoopWatch::expect_free(inspect);
}

TEST(Places, CalibrateNeverBlocksForMoreThan30Milliseconds) {
  static_cast<void>(MadeFingers::get());
  LoopWatch::expect_free(calibrate);
}

TEST(Places, AccuracyNeverBlocksForMoreThan30Milliseconds) {
  static_cast<void>(MeasuredFinger::get());
  LoopWatch::expect_free(accuracy);
}

}  // namespace
}  // namespace alltact::test
