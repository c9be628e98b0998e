// A whole use of the Studio, by mouse and keys alone: start, choose the camera, lock its exposure,
// record, see what the recording covers, and go on with it the next day.
#include "core/recording/video_file.h"
#include "core/simulation/plan.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/sanitized.h"
#include "widgets/panels/recording_checks.h"

#include <QAccessible>
#include <QCheckBox>
#include <QLineEdit>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

/// A camera that looks at the bending finger.
FakeOptions looking_at_a_finger() {
  const Plan plan = Plan::compile(Scene::load(MadeFingers::get().bending()).value(), 1).value();
  FakeOptions options;
  options.sizes = {{small_size_px().width, small_size_px().height}};
  for (int i = 0; i < 60; ++i) cv::imencode(".jpg", plan.render(i), options.packets.emplace_back());
  return options;
}

QString description_of(const QWidget& widget) {
  QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(&widget));
  return seen == nullptr ? QString() : seen->text(QAccessible::Description);
}

TEST(Story, FromTheFirstStartToTheNextDay) {
  FakeCamera fake(looking_at_a_finger());
  const TemporaryFolder folder;
  StudioOptions options;
  options.session_folder = folder / "session";
  options.opener = with_camera(fake);
  options.lister = [] {
    FoundCamera camera;
    camera.identity.name = "Finger camera";
    camera.identity.by_id = "camera";
    return std::vector<FoundCamera>{camera};
  };
  const std::filesystem::path video = folder / "bending.mkv";
  {
    Studio studio(options);
    ASSERT_TRUE(wait_until([&] {
      for (const QPushButton* button : studio.window().findChildren<QPushButton*>())
        if (button->isVisible() && button->text() == QLatin1String("Camera Finger camera"))
          return true;
      return false;
    }));
    studio.click("Camera Finger camera");
    ASSERT_TRUE(studio.wait_for_picture());
    studio.window().open_finger(MadeFingers::get().described());

    // Brightness is locked from the start; unlocked, changed, locked again.
    ASSERT_TRUE(wait_until([&] { return studio.session().status().controller.is_locked; }));
    auto* lock = studio.find<QCheckBox>("Lock brightness");
    ASSERT_NE(lock, nullptr);
    QTest::keyClick(lock, Qt::Key_Space);
    ASSERT_TRUE(wait_until([&] { return !studio.session().status().controller.is_locked; }));
    QTest::keyClick(lock, Qt::Key_Space);
    ASSERT_TRUE(wait_until([&] { return studio.session().status().controller.is_locked; }));
    EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);

    QTest::keyClick(&studio.window(), Qt::Key_3, Qt::ControlModifier);
    auto* file = studio.find<QLineEdit>("Recording file");
    ASSERT_NE(file, nullptr);
    file->selectAll();
    QTest::keyClicks(file, QString::fromStdString(video.string()));
    QTest::keyClick(&studio.window(), Qt::Key_R, Qt::ControlModifier);
    const RecordingStatus& recording = studio.session().status().recording;
    ASSERT_TRUE(wait_until([&] { return recording.seconds >= 5; }, 20000)) << studio.problems();
    QTest::keyClick(&studio.window(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
    if (!kIsSanitized) {
      EXPECT_EQ(recording.counts.dropped + recording.counts.missing, 0U);
    }
    const auto* coverage = studio.window().findChild<CoverageView*>();
    ASSERT_NE(coverage, nullptr);
    EXPECT_TRUE(description_of(*coverage).startsWith(QLatin1String("Missing: ")))
        << description_of(*coverage).toStdString();
    studio.close();
  }
  auto recorded = VideoFile::open(video);
  ASSERT_TRUE(recorded) << recorded.error().sentence();
  EXPECT_GT(recorded->frame_count(), 100U);

  Studio next_day(options);
  next_day.click("Go on with finger described, source camera");
  ASSERT_TRUE(next_day.wait_for_picture());
  EXPECT_TRUE(wait_until([&] {
    return next_day.session().status().finger.state == FingerState::kReady &&
           next_day.session().status().controller.is_locked;
  }));
  EXPECT_NE(next_day.find<QGroupBox>("Recording"), nullptr);  // the place it was left at
}

}  // namespace
}  // namespace alltact::test
