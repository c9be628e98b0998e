// The place Live, as a person uses it.
#include "core/open/open_source.h"
#include "tests/studio/studio_rig.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QSlider>
#include <QStatusBar>
#include <algorithm>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

bool wait_for_depth(Studio& studio) {
  return wait_until([&] {
    const auto& view = studio.session().view();
    return view && view->depth_layer;
  });
}

TEST(Live, BeginsWithTheSimulatedFingerByOneClick) {
  Studio studio;
  studio.click("Simulated finger");
  ASSERT_TRUE(wait_until([&] {
    const auto& view = studio.session().view();
    return view && view->result.markers.has_value();
  }));
  EXPECT_TRUE(studio.session().view()->result.edges);
  EXPECT_EQ(studio.problems(), "");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().source.delivered > 30; }));
  EXPECT_EQ(studio.session().status().source.missing, 0U);
  EXPECT_EQ(studio.find<QToolButton>("Finger: studio finger (simulated)")->toolTip(),
            "studio finger (simulated)");
}

/// Frames taken 30 times a second that come all at once.
class BelatedSource : public Source {
 public:
  Result<FramePtr> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // so that the test may go on
    auto frame = std::make_shared<Frame>();
    frame->grey = cv::Mat(48, 64, CV_8UC1, cv::Scalar(100));
    frame->origin = "belated";
    frame->sequence = number_++;
    frame->time_ns = static_cast<std::int64_t>(frame->sequence) * 1'000'000'000 / 30;
    return FramePtr(frame);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return std::nullopt; }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  std::uint64_t number_ = 0;
};

TEST(Live, TheStatusFitsASmallWindowInEveryLanguage) {
  StudioOptions options;
  options.opener = [](const auto&, const SourceOptions&) {
    return Result<std::unique_ptr<Source>>(std::make_unique<BelatedSource>());
  };
  options.source = {"belated"};
  Studio studio(options);
  ProgramAppearance appearance;
  for (const auto& [language, words] :
       {std::pair{"en", "30.0 frames/s"}, {"de", "30,0 Bilder/s"}, {"zh_CN", "30.0 帧/秒"}}) {
    appearance.apply({Theme::kLight, QLatin1String(language)});
    studio.window().resize(1024, 700);
    auto* bar = studio.window().statusBar();
    const auto labels = bar->findChildren<QLabel*>();
    const auto begins_with = [&](const QLabel* label) {
      return label->isVisible() && label->text().startsWith(QString::fromUtf8(words)) &&
             label->text().contains(QRegularExpression(QStringLiteral("[(（].+[)）]")));
    };
    ASSERT_TRUE(wait_until([&] { return std::any_of(labels.begin(), labels.end(), begins_with); }))
        << language;
    QTest::qWait(50);
    int text_px = 0;
    for (const QLabel* label : labels) {
      if (!label->isVisible()) continue;
      EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
      EXPECT_LE(label->geometry().right(), bar->width()) << label->text().toStdString();
      text_px += label->sizeHint().width();
    }
    // Two more digits and the mark of an old image still fit.
    EXPECT_LE(text_px + 60, bar->width()) << language;
  }
  appearance.apply({Theme::kLight, QStringLiteral("en")});
}

TEST(Live, AMaximisedWindowIsMaximisedAgain) {
  {
    Studio studio;
    EXPECT_FALSE(studio.window().isMaximized());
    studio.window().showMaximized();
    studio.close();
  }
  {
    Studio studio;
    EXPECT_TRUE(studio.window().isMaximized());
  }
  QSettings().remove(QStringLiteral("window/geometry"));
}

TEST(Live, BeginsWithTheSimulatedFingerByKeysAlone) {
  Studio studio;
  auto* button = studio.find<QPushButton>("Simulated finger");
  for (int i = 0; i < 50 && QApplication::focusWidget() != button; ++i)
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &studio.window(),
                    Qt::Key_Tab);
  ASSERT_EQ(QApplication::focusWidget(), button);
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_TRUE(studio.wait_for_picture());
}

TEST(Live, ShowsDepthOfACalibratedFinger) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_for_depth(studio));
  const auto& result = studio.session().view()->result;
  ASSERT_FALSE(result.regions.empty());
  EXPECT_NEAR(result.regions.front().deepest_mm, 0.8, 0.1);  // as the scene says
  EXPECT_EQ(studio.problems(), "");
}

TEST(Live, ReadsOutTheGreyValueUnderTheProbe) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_for_depth(studio));
  auto* view = studio.find<ImageView>("Image");
  view->setFocus();
  QTest::keyClick(view, Qt::Key_Right, Qt::ShiftModifier);
  const auto at = view->probe();
  ASSERT_TRUE(at);
  const int grey = view->image().at<std::uint8_t>(at->y(), at->x());
  const QString text = studio.find<QLabel>("Values at the probe")->text();
  EXPECT_THAT(text.toStdString(),
              HasSubstr("u " + std::to_string(at->x()) + " px, v " + std::to_string(at->y()) +
                        " px, grey " + std::to_string(grey) + ", depth "));
}

TEST(Live, SwitchesOverlaysByMouseAndUndoesByKeys) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_for_depth(studio));
  auto* markers = studio.find<QCheckBox>("Markers with numbers");
  ASSERT_TRUE(markers->isChecked());
  QTest::mouseClick(markers, Qt::LeftButton, {}, {8, markers->height() / 2});
  EXPECT_FALSE(markers->isChecked());
  EXPECT_EQ(studio.window().undo_stack().undoText(), "hide Markers with numbers");
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(markers->isChecked());
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(markers->isChecked());
}

TEST(Live, EveryOverlayChangesWhatIsPainted) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_for_depth(studio));
  LiveView view = *studio.session().view();
  // The ball does not move this finger; another force would.
  view.result.push = Push{
      {20, 0}, Eigen::Matrix2d::Identity(), Eigen::Vector3d(1, 0, 0), 1.0, PushedFace::kContact};
  const auto painted = [&](const ViewOptions& options) {
    ImageView image;
    image.resize(960, 540);
    image.show_image(view.result.grey, overlays_for(view, options));
    return image.grab().toImage();
  };
  ViewOptions none;
  none.edges = none.markers = none.direction = none.depth = none.faults = false;
  const QImage bare = painted(none);
  for (const auto member :
       {&ViewOptions::edges, &ViewOptions::markers, &ViewOptions::direction, &ViewOptions::depth}) {
    ViewOptions one = none;
    one.*member = true;
    EXPECT_NE(painted(one), bare);
  }
}

TEST(Live, GoesFromPlaceToPlaceByKeys) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  QTest::keyClick(&studio.window(), Qt::Key_3, Qt::ControlModifier);
  EXPECT_NE(studio.find<QGroupBox>("Recording"), nullptr);
  QTest::keyClick(&studio.window(), Qt::Key_1, Qt::ControlModifier);
  EXPECT_NE(studio.find<QGroupBox>("Image overlays"), nullptr);
}

TEST(Live, LocksACameraAtFirstAndSetsItWhenUnlocked) {
  FakeCamera fake({});
  StudioOptions options;
  options.opener = with_camera(fake);
  options.source = {"camera"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return studio.session().status().controller.is_locked; }));
  EXPECT_EQ(fake.control(V4L2_CID_EXPOSURE_AUTO), V4L2_EXPOSURE_MANUAL);
  ASSERT_TRUE(wait_until([&] { return studio.window().findChild<QSlider*>() != nullptr; }));
  auto* exposure = studio.find<QSlider>("Exposure time");
  ASSERT_NE(exposure, nullptr);
  EXPECT_FALSE(exposure->isEnabled());
  auto* lock = studio.find<QCheckBox>("Lock brightness");
  QTest::keyClick(lock, Qt::Key_Space);
  ASSERT_TRUE(wait_until([&] { return exposure->isEnabled(); }));
  const int before = fake.control(V4L2_CID_EXPOSURE_ABSOLUTE);
  QTest::keyClick(exposure, Qt::Key_Right);
  ASSERT_TRUE(wait_until([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == before + 1; }));
  QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(wait_until([&] { return fake.control(V4L2_CID_EXPOSURE_ABSOLUTE) == before; }));
}

TEST(Live, SaysThatTheCameraWasUnpluggedAndGoesOnWhenItIsBack) {
  FakeCamera fake({});
  StudioOptions options;
  options.opener = with_camera(fake);
  options.source = {"camera"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  fake.unplug();
  ASSERT_TRUE(wait_until([&] {
    return studio.problems().find("The camera was unplugged") != std::string::npos ||
           studio.problems().find("the camera was unplugged") != std::string::npos;
  }));
  EXPECT_THAT(studio.problems(), HasSubstr("plug it in again"));
  const auto before = studio.session().status().source.delivered;
  fake.plug_in();
  EXPECT_TRUE(wait_until([&] { return studio.session().status().source.delivered > before + 10; }));
  EXPECT_TRUE(wait_until([&] {
    return studio.problems().find("was unplugged") == std::string::npos;
  })) << studio.problems();
}

TEST(Live, SaysThatTheCameraIsTakenAndTheProgramGoesOn) {
  FakeCamera fake({});
  fake.fail(VIDIOC_S_FMT, EBUSY, 1);
  StudioOptions options;
  options.opener = with_camera(fake);
  options.source = {"camera"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  EXPECT_THAT(studio.problems(), HasSubstr("another program"));
  EXPECT_THAT(studio.problems(), HasSubstr("Try: "));
  studio.window().open_source({MadeFingers::get().bending()});
  EXPECT_TRUE(studio.wait_for_picture());
  EXPECT_TRUE(wait_until([&] { return studio.problems().empty(); }));
}

TEST(Live, SaysWhichCameraIsNotThere) {
  StudioOptions options;
  options.source = {"usb-no-such-camera"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  EXPECT_THAT(studio.problems(), HasSubstr("no camera"));
}

TEST(Live, SaysWhatIsWrongWithAFingerAndShowsThePictureAllTheSame) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "broken");
  QFile file(QString::fromStdString((folder / "broken/finger.yaml").string()));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("format: alltact-finger/1\nname: broken\nface: {kind: round}\n");
  file.close();
  StudioOptions options = simulated();
  options.finger = folder / "broken";
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  EXPECT_THAT(studio.problems(), HasSubstr("finger.yaml"));
  EXPECT_TRUE(wait_until([&] { return studio.session().status().source.delivered > 20; }));
}

TEST(Live, SaysThatAFingerIsOfAnotherCamera) {
  const TemporaryFolder folder;
  QFile scene(QString::fromStdString((folder / "large.yaml").string()));
  ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
  scene.write(small_scene(false, 480).c_str());
  scene.close();
  StudioOptions options = simulated();
  options.source = {folder / "large.yaml"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return studio.problems().find("480") != std::string::npos; }));
  EXPECT_THAT(studio.problems(), HasSubstr(std::to_string(small_size_px().width)));
}

TEST(Live, TellsWhenAVideoEndsAndPlaysItAgain) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(
        QImage(64, 48, QImage::Format_Grayscale8)
            .save(QString::fromStdString((folder / ("p" + std::to_string(i) + ".png")).string())));
  StudioOptions options;
  options.source = {folder.path()};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  EXPECT_THAT(studio.problems(), HasSubstr("The source has ended"));
  EXPECT_EQ(studio.session().status().source.delivered, 3U);
  studio.click("Play it again");
  EXPECT_TRUE(wait_until([&] {
    return studio.session().status().source.state == SourceState::kEnded &&
           studio.session().status().source.delivered == 3;
  }));
}

TEST(Live, GoesOnAfterACrashWithWhatWasKept) {
  const TemporaryFolder folder;
  StudioOptions options;
  options.session_folder = folder / "session";
  SessionState kept;
  kept.finger = MadeFingers::get().calibrated();
  kept.source = {MadeFingers::get().touched()};
  kept.view.edges = false;
  { SessionStore(options.session_folder).keep(kept); }
  leave_as_after_a_crash(options.session_folder);
  Studio studio(options);
  EXPECT_THAT(studio.problems(), HasSubstr("ended unexpectedly"));
  studio.click("Go on with it");
  ASSERT_TRUE(wait_for_depth(studio));
  EXPECT_FALSE(studio.find<QCheckBox>("Edges of the face")->isChecked());
  EXPECT_EQ(studio.problems(), "");
}

}  // namespace
}  // namespace alltact::test
