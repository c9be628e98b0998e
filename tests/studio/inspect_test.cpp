// The place Inspect, as a person uses it. On Qt's offscreen platform it shows height maps; 3D is
// looked at on a screen (see tests/scene3d).
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "core/recording/video_file.h"
#include "core/sensing/surface_measurement.h"
#include "tests/studio/studio_rig.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/inspect/point_readings.h"

#include <QAccessible>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTableWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

class Inspect : public testing::Test {
 protected:
  static StudioOptions options() {
    StudioOptions options;
    options.finger = MadeFingers::get().calibrated();
    return options;
  }
  Inspect() : studio_(options()) { studio_.window().go_to("inspect"); }

  InspectPage& place() { return *studio_.window().findChild<InspectPage*>(); }
  const InspectedFrame& frame() { return *place().inspection().frame(); }
  bool open_pictures() {
    place().open(MadeFingers::get().touched_pictures());
    return wait_until(
        [&] { return place().inspection().frame() && place().inspection().frame()->surface; });
  }
  std::string text(const QString& label) {
    return studio_.find<QLabel>(label)->text().toStdString();
  }
  void set(const QString& name, double value) {
    auto* box = studio_.find<QDoubleSpinBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QString::number(value));
    QTest::keyClick(box, Qt::Key_Return);
  }
  Studio studio_;
};

TEST_F(Inspect, MeasuresARecording) {
  ASSERT_TRUE(open_pictures());
  EXPECT_EQ(place().inspection().recording()->count, 6U);
  ASSERT_FALSE(frame().result.regions.empty());
  EXPECT_NEAR(frame().result.regions.front().deepest_mm, 0.8, 0.1);  // as the scene says
  EXPECT_THAT(
      text("Deepest contact"),
      HasSubstr(
          "Deepest " +
          QLocale().toString(frame().result.regions.front().deepest_mm, 'f', 2).toStdString()));
  EXPECT_EQ(studio_.problems(), "");
}

TEST_F(Inspect, MeasuresAgainWhenTheFingerIsCalibratedAgain) {
  ASSERT_TRUE(open_pictures());
  const double before_mm = frame().result.regions.front().deepest_mm;
  const auto store = FingerStore::of(MadeFingers::get().calibrated());
  const Finger kept = store->snapshot().value()->finger;
  ASSERT_TRUE(store->update([](Finger& finger) {
    finger.mapping->a_mm *= 1.25;
    return Status();
  }));
  EXPECT_TRUE(wait_until([&] {
    const auto& now = place().inspection().frame();
    return now && !now->result.regions.empty() &&
           std::abs(now->result.regions.front().deepest_mm - 1.25 * before_mm) < 0.02;
  })) << frame().result.regions.front().deepest_mm
      << " after " << before_mm;
  EXPECT_TRUE(wait_until([&] {
    const auto& live = studio_.session().status().finger;
    return live.finger && live.finger->mapping->a_mm != kept.mapping->a_mm;
  })) << "the live picture follows, too";
  // Another program puts it back: the window sees that by itself.
  ASSERT_TRUE(kept.save(MadeFingers::get().calibrated()));
  EXPECT_TRUE(wait_until(
      [&] {
        const auto& now = place().inspection().frame();
        return now && !now->result.regions.empty() &&
               std::abs(now->result.regions.front().deepest_mm - before_mm) < 1e-6;
      },
      10000));
}

TEST_F(Inspect, ReadsPlacesAsTheCommandLineWritesThem) {
  ASSERT_TRUE(open_pictures());
  studio_.click("Deepest");
  ASSERT_TRUE(place().options().a);
  const cv::Point at(*pixel_of(frame(), place().options().a));
  const cv::Mat points = contact_face_points_mm(frame().result, frame().face);
  const auto& p = points.at<cv::Vec3f>(at);
  const float depth = frame().result.depth->depth_mm.at<float>(at);
  const QLocale locale;
  const std::string reading = text("Measured at the points");
  EXPECT_THAT(reading,
              HasSubstr(QStringLiteral("x %1, y %2, z %3 mm")
                            .arg(locale.toString(p[0], 'f', 2), locale.toString(p[1], 'f', 2),
                                 locale.toString(p[2], 'f', 2))
                            .toStdString()));
  const float sd_mm = frame().sd_mm.at<float>(at);
  const QString sd = sd_mm < 0.005F ? QStringLiteral("under ") + locale.toString(0.01, 'f', 2)
                                    : locale.toString(sd_mm, 'f', 2);
  EXPECT_THAT(reading, HasSubstr(QStringLiteral("depth %1 ± %2 mm")
                                     .arg(locale.toString(depth, 'f', 2), sd)
                                     .toStdString()));
  EXPECT_GT(frame().sd_mm.at<float>(at), 0.0F);
}

TEST_F(Inspect, TellsHowFarTwoPointsAreApart) {
  ASSERT_TRUE(open_pictures());
  set("Point A, along the finger", 30);
  set("Point A, across it", -2.5);
  set("Point B, along the finger", 47.25);
  set("Point B, across it", 3);
  EXPECT_EQ(place().options().a, (FacePosition{30, -2.5}));
  EXPECT_EQ(place().options().b, (FacePosition{47.25, 3}));
  const auto a = pixel_of(frame(), place().options().a), b = pixel_of(frame(), place().options().b);
  ASSERT_TRUE(a && b);
  const auto distance = distance_between(frame().result, frame().face, *a, *b);
  ASSERT_TRUE(distance);
  EXPECT_THAT(
      text("Measured at the points"),
      HasSubstr(QLocale().toString(distance->straight_mm, 'f', 2).toStdString() + " mm straight"));
  EXPECT_GE(distance->along_face_mm, distance->straight_mm);
  EXPECT_LT(distance->along_face_mm, 1.05 * distance->straight_mm);
  // What the command line writes of the pixels around.
  const cv::Mat points = contact_face_points_mm(frame().result, frame().face);
  const cv::Vec3d apart = points.at<cv::Vec3f>(cv::Point(*b)) - points.at<cv::Vec3f>(cv::Point(*a));
  EXPECT_NEAR(distance->straight_mm, cv::norm(apart), 0.3) << "a pixel at both ends";
}

TEST_F(Inspect, AProfileIsTheDepthAlongTheLine) {
  ASSERT_TRUE(open_pictures());
  studio_.click("Deepest");
  const cv::Point2d deepest = *pixel_of(frame(), place().options().a);
  studio_.click("Across");
  const auto [a, b] =
      std::pair(*pixel_of(frame(), place().options().a), *pixel_of(frame(), place().options().b));
  EXPECT_EQ(a.x, deepest.x);
  EXPECT_EQ(b.x, deepest.x);
  const Profile profile = profile_between(frame().result, frame().face, frame().sd_mm, a, b);
  // The face is 24 mm wide; its outer side lies a little further from the camera.
  EXPECT_NEAR(profile.along_mm.back(), 24, 1.0);
  double most = 0;
  for (const double depth : profile.depth_mm)
    if (std::isfinite(depth)) most = std::max(most, depth);
  EXPECT_FLOAT_EQ(static_cast<float>(most),
                  frame().result.depth->depth_mm.at<float>(cv::Point(deepest)));
}

TEST_F(Inspect, MeasuresWhatLiesBetweenThePoints) {
  ASSERT_TRUE(open_pictures());
  studio_.click("Deepest");
  const cv::Point2d deepest = *pixel_of(frame(), place().options().a);
  InspectOptions box = place().options();
  box.a = position_of(frame(), deepest - cv::Point2d(14, 26));
  box.b = position_of(frame(), deepest + cv::Point2d(14, 26));
  place().restore(box, frame().number);
  auto* table = studio_.find<QTableWidget>("Measured between the points");
  ASSERT_NE(table, nullptr);
  const auto readings = surface_readings(frame(), *pixel_of(frame(), place().options().a),
                                         *pixel_of(frame(), place().options().b), {});
  ASSERT_EQ(static_cast<std::size_t>(table->rowCount()), readings.size());
  const MeasuredValue apart = readings.front().reading.measured.value();
  EXPECT_NEAR(apart.value,
              distance_between(frame().result, frame().face, deepest - cv::Point2d(14, 26),
                               deepest + cv::Point2d(14, 26))
                  ->straight_mm,
              1e-6);
  EXPECT_GT(apart.sd, 0);
  EXPECT_LT(apart.sd, 0.1);
  const MeasuredValue radius = readings[1].reading.measured.value();
  EXPECT_NEAR(radius.value, 4.0, std::max(3 * radius.sd, 0.1)) << "as the scene says";
  EXPECT_LT(radius.sd, 0.5);
  // The box ends between pixels, the region on them: the wider they are the less alike.
  const double alike = 0.05 * 960 / small_size_px().width;
  EXPECT_NEAR(readings[3].reading.measured.value().value, frame().result.regions.front().volume_mm3,
              alike * frame().result.regions.front().volume_mm3);
  EXPECT_EQ(table->item(1, 1)->text(), value_text(readings[1].what, readings[1].reading));
  studio_.click("Copy as CSV");
  EXPECT_EQ(QGuiApplication::clipboard()->text(), csv_of(readings));
  studio_.click("Copy as text");
  EXPECT_THAT(QGuiApplication::clipboard()->text().toStdString(),
              HasSubstr("Ball's radius: " +
                        value_text(readings[1].what, readings[1].reading).toStdString() + "\n"));
  constexpr int kRoughness = 5;
  auto* lambda = studio_.find<NumberField>("Longest wavelength of roughness");
  ASSERT_NE(lambda, nullptr);
  lambda->setValue(2.0);
  const auto filtered = surface_readings(frame(), *pixel_of(frame(), place().options().a),
                                         *pixel_of(frame(), place().options().b),
                                         {.form_degree = 2, .lambda_c_mm = 2.0});
  EXPECT_LT(filtered[kRoughness].reading.measured.value().value,
            readings[kRoughness].reading.measured.value().value);
  EXPECT_EQ(table->item(kRoughness, 1)->text(),
            value_text(Measurand::kRoughness, filtered[kRoughness].reading));
  table->selectRow(kRoughness);
  studio_.click("Add to recipe");
  ASSERT_EQ(place().options().recipe.readings.size(), 1U);
  EXPECT_EQ(place().options().recipe.readings.front().filter.lambda_c_mm, 2.0);
  studio_.window().undo_stack().undo();
  studio_.window().undo_stack().undo();
  EXPECT_FALSE(place().options().filter.lambda_c_mm);
  EXPECT_EQ(lambda->text(), QStringLiteral("all"));
  EXPECT_EQ(table->item(kRoughness, 1)->text(),
            value_text(Measurand::kRoughness, readings[kRoughness].reading));
  studio_.click("Across");  // a line is no box
  EXPECT_EQ(table->item(1, 1)->text(), QStringLiteral("–"));
  EXPECT_FALSE(table->item(1, 1)->toolTip().isEmpty());
}

TEST_F(Inspect, PutsPointsByClicksAndTakesThemBack) {
  ASSERT_TRUE(open_pictures());
  auto* map = studio_.find<ImageView>("Image");
  const QPoint where = map->transform().to_widget({400, 260}).toPoint();
  QTest::mouseClick(map, Qt::LeftButton, {}, where);
  ASSERT_TRUE(place().options().a);
  EXPECT_NEAR(pixel_of(frame(), place().options().a)->x, 400, 2);
  EXPECT_NEAR(pixel_of(frame(), place().options().a)->y, 260, 2);
  EXPECT_FALSE(place().options().b);
  QTest::mouseClick(map, Qt::RightButton, {}, where + QPoint(30, 0));
  EXPECT_TRUE(place().options().b);
  EXPECT_EQ(studio_.window().undo_stack().undoText(), "set point B");
  QTest::keyClick(&studio_.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(place().options().b);
  QTest::keyClick(&studio_.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(place().options().a);
  QTest::keyClick(&studio_.window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(place().options().a);
}

TEST_F(Inspect, ScrubsByKeysAndPlaysToTheEnd) {
  ASSERT_TRUE(open_pictures());
  auto* slider = studio_.find<QSlider>("Frame of the recording");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  QTest::keyClick(slider, Qt::Key_Right);
  ASSERT_TRUE(wait_until([&] { return frame().number == 2; }));
  EXPECT_EQ(text("Frame name"), "frame_00002");
  studio_.click("Play");
  ASSERT_TRUE(wait_until([&] { return frame().number == 5; }));
  ASSERT_TRUE(
      wait_until([&] { return studio_.window().findChild<TimeLine*>()->is_playing() == false; }));
  EXPECT_EQ(text("Frame name"), "frame_00005");
}

TEST_F(Inspect, GivesTheSameNumbersWhicheverWayOneComes) {
  ASSERT_TRUE(open_pictures());
  const cv::Mat first = frame().result.depth->depth_mm.clone();
  auto* slider = studio_.find<QSlider>("Frame of the recording");
  slider->setValue(4);
  ASSERT_TRUE(wait_until([&] { return frame().number == 4; }));
  slider->setValue(0);
  ASSERT_TRUE(wait_until([&] { return frame().number == 0; }));
  EXPECT_EQ(cv::norm(first, frame().result.depth->depth_mm, cv::NORM_INF), 0.0);
}

TEST_F(Inspect, SavesTheBytesThatTheCommandLineWrites) {
  ASSERT_TRUE(open_pictures());
  const TemporaryFolder out;
  for (const char* ending : {"ply", "vtp", "stl", "glb", "tiff"}) {
    place().save(out / (std::string("a.") + ending));
    ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }));
  }
  const ProgramRun run = run_alltact(
      {"reconstruct", MadeFingers::get().calibrated().string(),
       (MadeFingers::get().touched_pictures() / "frame_00000.png").string(), "-o",
       (out / "cli").string(), "--format", "depth,rectified,ply,vtp,stl,glb", "--picture"});
  ASSERT_EQ(run.status, 0) << run.errors;
  for (const char* ending : {"ply", "vtp", "stl", "glb", "tiff"}) {
    const std::string ours = text_of(out / (std::string("a.") + ending));
    EXPECT_GT(ours.size(), 100000U);
    const std::string name = ending == std::string("tiff") ? "frame_00000.rectified.tiff"
                                                           : std::string("frame_00000.") + ending;
    EXPECT_TRUE(ours == text_of(out / "cli" / name)) << ending;
  }
  EXPECT_TRUE(std::filesystem::exists(out / "cli" / "frame_00000.3d.png"));
}

TEST_F(Inspect, SavesAPictureAndAFilm) {
  ASSERT_TRUE(open_pictures());
  const TemporaryFolder out;
  place().save(out / "view.png");
  ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }));
  const QImage image(QString::fromStdString((out / "view.png").string()));
  EXPECT_NEAR(image.width(), 2008, 2) << "17 cm of 300 dots an inch";
  EXPECT_NEAR(image.dotsPerMeterX(), 300 / 0.0254, 1);
  place().save(out / "film.mkv");
  ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }, 60000));
  auto film = VideoFile::open(out / "film.mkv");
  ASSERT_TRUE(film) << film.error().sentence();
  EXPECT_EQ(film->frame_count(), 6U);
  const auto last = film->frame(5);
  ASSERT_TRUE(last);
  EXPECT_EQ((*last)->grey.size(), cv::Size(1280, 720));
  double low = 0, high = 0;
  cv::minMaxLoc((*last)->grey, &low, &high);
  EXPECT_GT(high - low, 100) << "ground, and a face on it";
  place().save("/nowhere/a.ply");
  ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }));
  EXPECT_THAT(text("What was saved"), HasSubstr("/nowhere"));
}

TEST_F(Inspect, ShowsTheLiveFingerAndComesBackToIt) {
  studio_.window().open_source({MadeFingers::get().touched()});
  ASSERT_TRUE(wait_until(
      [&] { return place().inspection().frame() && place().inspection().frame()->surface; }));
  ASSERT_TRUE(open_pictures());
  EXPECT_TRUE(place().inspection().recording());
  studio_.click("Live finger");
  ASSERT_TRUE(wait_until(
      [&] { return place().inspection().frame() && !place().inspection().recording(); }));
}

TEST_F(Inspect, KnowsEveryFrameOfARecordingThatIsOpenedAgain) {
  const auto is_complete = [&] { return place().inspection().summaries().size() == 6; };
  studio_.window().open_source({MadeFingers::get().touched()});
  ASSERT_TRUE(open_pictures());
  ASSERT_TRUE(wait_until(is_complete));
  const std::vector<FrameSummary> first = place().inspection().summaries();
  studio_.click("Live finger");
  ASSERT_TRUE(wait_until(
      [&] { return place().inspection().frame() && !place().inspection().recording(); }));
  ASSERT_TRUE(open_pictures());
  ASSERT_TRUE(wait_until(is_complete)) << place().inspection().summaries().size();
  const std::vector<FrameSummary> second = place().inspection().summaries();
  for (const FrameSummary& summary : first)
    EXPECT_EQ(std::count_if(second.begin(), second.end(),
                            [&](const FrameSummary& other) {
                              return other.number == summary.number &&
                                     other.deepest_mm == summary.deepest_mm;
                            }),
              1)
        << summary.number;
  auto* later = studio_.find<QToolButton>("Next contact or problem");
  EXPECT_TRUE(wait_until([&] { return later->isEnabled(); }));
}

TEST_F(Inspect, NamesBothFingersOfARecordingThatAnotherFingerMeasures) {
  ASSERT_TRUE(open_pictures());
  EXPECT_EQ(studio_.problems(), "");
  const TemporaryFolder shelf;
  std::filesystem::copy(MadeFingers::get().calibrated(), shelf / "other",
                        std::filesystem::copy_options::recursive);
  studio_.window().open_finger(shelf / "other");
  ASSERT_TRUE(wait_until([&] { return !studio_.problems().empty(); }));
  EXPECT_THAT(studio_.problems(), HasSubstr(MadeFingers::get().calibrated().string()));
  EXPECT_THAT(studio_.problems(), HasSubstr((shelf / "other").string()));
  studio_.window().open_finger(MadeFingers::get().calibrated());
  EXPECT_TRUE(wait_until([&] { return studio_.problems().empty(); }));
  studio_.window().open_finger(shelf / "other");
  ASSERT_TRUE(wait_until([&] { return !studio_.problems().empty(); }));
  studio_.click("Close the recording");
  EXPECT_TRUE(place().options().recording.empty());
  EXPECT_TRUE(wait_until([&] { return studio_.problems().empty(); }));
}

TEST_F(Inspect, SaysWhyThereIsNothing) {
  auto* map = studio_.find<ImageView>("Image");
  ASSERT_TRUE(wait_until(
      [&] { return map->accessibleDescription().contains(QStringLiteral("No source is open")); }));
  place().open("/nowhere/video.mkv");
  ASSERT_TRUE(wait_until([&] { return !studio_.problems().empty(); }));
  EXPECT_THAT(studio_.problems(), HasSubstr("/nowhere/video.mkv"));
}

TEST_F(Inspect, IsNamedForThoseWhoHearIt) {
  ASSERT_TRUE(open_pictures());
  for (const QWidget* widget : place().findChildren<QWidget*>()) {
    if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
    if (qobject_cast<const QLineEdit*>(widget) != nullptr) continue;  // within spin boxes
    QAccessibleInterface* seen =
        QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    ASSERT_NE(seen, nullptr);
    EXPECT_FALSE(seen->text(QAccessible::Name).isEmpty()) << widget->metaObject()->className();
  }
}

TEST_F(Inspect, ComesByKeys) {
  studio_.window().go_to("live");
  QTest::keyClick(&studio_.window(), Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(place().isVisible());
}

}  // namespace
}  // namespace alltact::test
