// What the place Inspect compares, tells under the pointer and over time, and writes for papers.
#include "app/studio/session.h"
#include "core/recording/video_file.h"
#include "core/sensing/surface_measurement.h"
#include "tests/studio/two_fingers.h"
#include "tests/support/made_meshes.h"
#include "widgets/inspect/inspect_side.h"
#include "widgets/inspect/inspected_frame.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class InspectMore : public testing::Test {
 protected:
  static StudioOptions options() {
    StudioOptions options;
    options.finger = MadeFingers::get().calibrated();
    return options;
  }
  InspectMore() : studio_(options()) { studio_.window().go_to("inspect"); }

  InspectPage& place() { return *studio_.window().findChild<InspectPage*>(); }
  const InspectedFrame& frame() { return *place().inspection().frame(); }
  bool open(const fs::path& recording) {
    place().open(recording);
    return wait_until(
        [&] { return place().inspection().frame() && place().inspection().frame()->surface; },
        20000);
  }
  bool open_pictures() { return open(MadeFingers::get().touched_pictures()); }
  std::string text(const QString& label) {
    return studio_.find<QLabel>(label)->text().toStdString();
  }
  void change(const std::function<void(InspectOptions&)>& change) {
    InspectOptions next = place().options();
    change(next);
    place().restore(next, place().frame_number());
  }
  void save(const fs::path& file) {
    place().save(file);
    ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }, 60000));
  }
  Studio studio_;
};

TEST_F(InspectMore, ComparesWithThePapersMethod) {
  ASSERT_TRUE(open_pictures());
  auto* compare = studio_.find<QComboBox>("Compare");
  QTest::keyClick(compare, Qt::Key_Down);
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }));
  EXPECT_EQ(place().options().comparison, Comparison::kSideBySide);
  EXPECT_NE(studio_.find<QLabel>("Compared with: the source paper's method"), nullptr);
  EXPECT_GT(cv::countNonZero(cv::abs(frame().difference_mm) > 0), 1000) << "the methods differ";
  QTest::keyClick(&studio_.window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(place().options().comparison, Comparison::kNone);
  EXPECT_TRUE(wait_until([&] { return !frame().other.has_value(); }));
}

TEST_F(InspectMore, NeverShowsOrdinaryDepthUnderTheTitleOfADifference) {
  ASSERT_TRUE(open_pictures());
  auto* map = studio_.find<ImageView>("Image");
  change([](InspectOptions& options) { options.comparison = Comparison::kDifference; });
  if (!frame().other) {
    EXPECT_TRUE(map->image().empty());
    EXPECT_THAT(map->accessibleDescription().toStdString(), HasSubstr("being measured"));
  }
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }));
  EXPECT_FALSE(map->image().empty());
}

TEST_F(InspectMore, ComparesWithAnotherSetting) {
  ASSERT_TRUE(open_pictures());
  change([](InspectOptions& options) {
    options.comparison = Comparison::kSideBySide;
    options.with = {OtherMethod::kSetting, "smoothing-px", "0"};
  });
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }, 20000));
  EXPECT_NE(studio_.find<QLabel>("Compared with: no smoothing"), nullptr);
  // Without smoothing the depth is rougher; its mean stays.
  cv::Mat difference = frame().difference_mm.clone();
  const cv::Mat known = difference == difference;
  difference.setTo(0, ~known);
  cv::Scalar mean, sd;
  cv::meanStdDev(difference, mean, sd, known);
  EXPECT_LT(std::abs(mean[0]), 0.005);
  EXPECT_GT(sd[0], 0.002);
}

TEST_F(InspectMore, ComparesWithAnotherFrameAtTheSamePlacesOfTheFace) {
  ASSERT_TRUE(open_pictures());
  studio_.click("Deepest");
  change([](InspectOptions& options) {
    options.comparison = Comparison::kDifference;
    options.with.method = OtherMethod::kFrame;
    options.with.frame = 0;
  });
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }, 20000));
  EXPECT_LT(
      cv::norm(frame().difference_mm, cv::NORM_INF, frame().difference_mm == frame().difference_mm),
      1e-4)
      << "a frame is like itself";
  change([](InspectOptions& options) { options.with.frame = 5; });
  ASSERT_TRUE(
      wait_until([&] { return frame().other && frame().other->frame->name == "frame_00005"; }));
  EXPECT_NE(studio_.find<QLabel>("Shown minus: frame 6"), nullptr);
  // The ball presses the same place of the finger, which lies in another pixel there.
  const cv::Point2d here = *pixel_of(frame(), place().options().a);
  EXPECT_LT(std::abs(frame().difference_mm.at<float>(cv::Point(here))), 0.05F);
  auto* number = studio_.find<QSpinBox>("Frame number");
  ASSERT_NE(number, nullptr);
  EXPECT_EQ(number->value(), 6);
  EXPECT_EQ(number->maximum(), 6);
}

TEST_F(InspectMore, ComparesWithABodyThatIsChosen) {
  const TemporaryFolder folder;
  const fs::path ball_file = folder / "ball.stl";
  write_stl(ball_file, ball(4.0));
  ASSERT_TRUE(open_pictures());
  change([](InspectOptions& options) { options.comparison = Comparison::kDifference; });
  auto* with = studio_.find<QComboBox>("With");
  ASSERT_NE(with, nullptr);
  const int before = with->currentIndex();
  with->setFocus();
  QTest::keyClick(with, Qt::Key_End);
  auto* dialog = studio_.window().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr) << "it asks for the file";
  EXPECT_EQ(with->currentIndex(), before) << "until one is chosen";
  auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  name->setText(QString::fromStdString(ball_file.string()));
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return frame().body_rms_mm.has_value(); }, 20000));
  EXPECT_LT(*frame().body_rms_mm, 0.03);
  EXPECT_EQ(with->currentIndex(), with->count() - 1);
  EXPECT_EQ(studio_.find<QPushButton>("ball.stl")->isVisible(), true);
  studio_.window().undo_stack().undo();
  EXPECT_NE(place().options().with.method, OtherMethod::kBody);
}

TEST_F(InspectMore, ComparesWithAnotherFinger) {
  const TemporaryFolder folder;
  fs::copy(MadeFingers::get().calibrated(), folder / "other", fs::copy_options::recursive);
  ASSERT_TRUE(open_pictures());
  change([](InspectOptions& options) { options.comparison = Comparison::kDifference; });
  auto* with = studio_.find<QComboBox>("With");
  ASSERT_NE(with, nullptr);
  with->setFocus();
  QTest::keyClick(with, Qt::Key_End);  // a body: it asks for a file
  auto* files = studio_.window().findChild<QFileDialog*>();
  ASSERT_NE(files, nullptr);
  QTest::keyClick(files, Qt::Key_Escape);
  with->setCurrentIndex(4);
  Q_EMIT with->activated(4);
  auto* dialog = studio_.window().findChild<SecondFingerDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto lines = dialog->findChildren<QLineEdit*>();
  ASSERT_EQ(lines.size(), 2);
  lines[0]->setText(QString::fromStdString((folder / "other").string()));
  lines[1]->setText(QString::fromStdString(MadeFingers::get().touched_pictures().string()));
  dialog->grab().save(QStringLiteral(ALLTACT_SCREENS "/compare_finger.png"));
  studio_.click("Compare");
  ASSERT_TRUE(wait_until([&] {
    return place().options().with.method == OtherMethod::kFinger && frame().other.has_value() &&
           !place().inspection().is_busy();
  }));
  EXPECT_NE(studio_.find<QLabel>("Shown minus: frame 1 of touched, finger other"), nullptr);
  // The same finger, frame and recording: the same depth.
  cv::Mat difference = frame().difference_mm.clone();
  cv::patchNaNs(difference, 0);
  EXPECT_LT(cv::norm(difference, cv::NORM_INF), 1e-3);
}

TEST_F(InspectMore, TellsUnderThePointerWhatTheCommandLineWrites) {
  ASSERT_TRUE(open_pictures());
  const TemporaryFolder out;
  const ProgramRun run =
      run_alltact({"reconstruct", MadeFingers::get().calibrated().string(),
                   (MadeFingers::get().touched_pictures() / "frame_00000.png").string(), "-o",
                   out.path().string(), "--format", "depth"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const cv::Mat written =
      cv::imread((out / "frame_00000.depth.tiff").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(written.type(), CV_32FC1);
  auto* map = studio_.find<ImageView>("Image");
  int told = 0;
  for (const cv::Point pixel :
       {cv::Point(400, 260), {300, 250}, {500, 270}, {430, 240}, {620, 265}}) {
    QTest::mouseMove(map, map->transform().to_widget({pixel.x + 0.0, pixel.y + 0.0}).toPoint());
    QTest::qWait(20);
    ASSERT_TRUE(map->probe());
    const cv::Point at(map->probe()->x(), map->probe()->y());
    const float depth_mm = written.at<float>(at);
    if (!std::isfinite(depth_mm)) continue;
    ++told;
    const double shown_mm = std::round(100.0 * depth_mm) / 100.0 + 0.0;  // no minus before zero
    EXPECT_THAT(text("Under the pointer"),
                StartsWith("depth " + QLocale().toString(shown_mm, 'f', 2).toStdString() + " ±"))
        << at;
  }
  EXPECT_GE(told, 4);
  QTest::mouseMove(map, QPoint(1, 1));
  QTest::qWait(20);
  EXPECT_THAT(text("Under the pointer"), HasSubstr("Point at the face"));
}

TEST_F(InspectMore, PointsStayOnTheFingerAndNotOnTheNextOne) {
  ASSERT_TRUE(open(TwoFingers::get().left_video()));
  studio_.click("Deepest");
  const FacePosition place_before = *place().options().a;
  const cv::Point2d pixel_before = *pixel_of(frame(), place_before);
  studio_.find<QSlider>("Frame of the recording")->setValue(5);
  ASSERT_TRUE(wait_until([&] { return frame().number == 5; }));
  EXPECT_EQ(*place().options().a, place_before);
  const cv::Point2d pixel = *pixel_of(frame(), place().options().a);
  EXPECT_NE(pixel, pixel_before) << "the finger has bent, and the picture of the place moved";
  EXPECT_NEAR(position_of(frame(), pixel)->along_mm, place_before.along_mm, 1e-6);
  EXPECT_NEAR(position_of(frame(), pixel)->across_mm, place_before.across_mm, 1e-6);
  studio_.window().open_finger(TwoFingers::get().right());
  ASSERT_TRUE(wait_until(
      [&] { return studio_.session().status().finger.folder == TwoFingers::get().right(); }));
  EXPECT_TRUE(wait_until([&] { return !place().options().a; }));
}

TEST_F(InspectMore, LooksThroughTheRecordingForItsEvents) {
  ASSERT_TRUE(open_pictures());
  const auto* line = studio_.window().findChild<TimeLine*>();
  ASSERT_TRUE(wait_until([&] { return place().inspection().summaries().size() == 6; }, 20000));
  EXPECT_TRUE(wait_until([&] {
    return line->strip().description().startsWith(QStringLiteral("1 contact"));
  })) << line->strip().description().toStdString();
  EXPECT_EQ(line->strip().events(), std::vector<std::size_t>{0});
  for (const FrameSummary& summary : place().inspection().summaries()) {
    EXPECT_NEAR(summary.deepest_mm.value(), 0.8, 0.1) << "as the scene says";
    EXPECT_GT(summary.area_mm2.value(), 5);
    EXPECT_TRUE(summary.has_contact);
  }
  EXPECT_EQ(frame().number, 0U) << "what is shown stays";
}

TEST_F(InspectMore, ShowsTheShapeOfAFingerThatNobodyCalibrated) {
  studio_.window().open_finger(MadeFingers::get().described());
  place().open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until(
      [&] { return place().inspection().frame() && place().inspection().frame()->bare; }, 20000));
  EXPECT_FALSE(frame().is_calibrated);
  EXPECT_TRUE(frame().bare->has_body);
  // Dots 4 mm behind the inner side of a layer of 1.5 mm, as the scene says.
  int seen = 0;
  for (const SurfaceMarker& marker : frame().bare->markers) {
    seen += marker.is_seen ? 1 : 0;
    EXPECT_NEAR(marker.behind_mm, 5.5, 0.4);
    EXPECT_NEAR(std::abs(marker.at_mm.y()), 12, 0.3);
  }
  EXPECT_EQ(seen, 12);
  EXPECT_NE(
      studio_.find<QLabel>("Not calibrated yet: the shape of the entire finger, without depth"),
      nullptr);
}

TEST_F(InspectMore, WritesTheCrossSectionForAPaper) {
  ASSERT_TRUE(open_pictures());
  studio_.click("Deepest");
  studio_.click("Across");
  const TemporaryFolder out;
  for (const char* ending : {"pdf", "svg", "csv"}) save(out / (std::string("a.") + ending));
  EXPECT_THAT(text_of(out / "a.pdf"), StartsWith("%PDF"));
  const std::string svg = text_of(out / "a.svg");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("Depth (mm)")) << "letters as letters";
  EXPECT_EQ(svg.find("<image"), std::string::npos) << "lines as lines";
  const Profile profile = profile_between(frame().result, frame().face, frame().sd_mm,
                                          *pixel_of(frame(), place().options().a),
                                          *pixel_of(frame(), place().options().b));
  std::istringstream csv(text_of(out / "a.csv"));
  std::string line;
  ASSERT_TRUE(std::getline(csv, line));
  EXPECT_EQ(line, "along_mm,depth_mm,sd_mm");
  std::size_t row = 0;
  for (; std::getline(csv, line); ++row) {
    ASSERT_LT(row, profile.along_mm.size());
    EXPECT_NEAR(std::stod(line), profile.along_mm[row], 1e-6);
    const std::string depth = line.substr(line.find(',') + 1);
    EXPECT_EQ(depth == ",", !std::isfinite(profile.depth_mm[row]));
    if (depth != ",") {
      EXPECT_NEAR(std::stod(depth), profile.depth_mm[row], 1e-6);
    }
  }
  EXPECT_EQ(row, profile.along_mm.size());
}

TEST_F(InspectMore, FilmsBothFingers) {
  ASSERT_TRUE(open(TwoFingers::get().left_video()));
  place().open_second(SecondFinger{TwoFingers::get().right(), TwoFingers::get().right_video()});
  ASSERT_TRUE(wait_until([&] { return place().pair().frames().has_value(); }, 20000));
  const TemporaryFolder out;
  save(out / "both.mkv");
  auto film = VideoFile::open(out / "both.mkv");
  ASSERT_TRUE(film) << film.error().sentence();
  EXPECT_EQ(film->frame_count(), 6U);
  const cv::Mat last = (*film->frame(5))->grey;
  ASSERT_EQ(last.size(), cv::Size(1280, 720));
  for (const int left : {0, 640}) {
    double low = 0, high = 0;
    cv::minMaxLoc(last(cv::Rect(left, 0, 640, 720)), &low, &high);
    EXPECT_GT(high - low, 100) << "a face in both halves";
  }
}

TEST_F(InspectMore, FilmsTheLiveFinger) {
  studio_.window().open_source({MadeFingers::get().touched()});
  ASSERT_TRUE(wait_until(
      [&] { return place().inspection().frame() && place().inspection().frame()->surface; }));
  const TemporaryFolder out;
  place().save(out / "live.mkv");
  QTest::qWait(1500);
  EXPECT_TRUE(place().is_saving()) << "it goes on until it is stopped";
  studio_.click("Stop");
  ASSERT_TRUE(wait_until([&] { return !place().is_saving(); }, 20000));
  auto film = VideoFile::open(out / "live.mkv");
  ASSERT_TRUE(film) << film.error().sentence();
  EXPECT_GT(film->frame_count(), 2U);
}

// What is compared with comes back from its file; where that was removed, the window says so and
// compares with nothing.
TEST(InspectSession, GoesOnComparingWithTheFileThatWasChosen) {
  const TemporaryFolder folder;
  const fs::path ball_file = folder / "ball.stl";
  write_stl(ball_file, ball(4.0));
  SessionState kept;
  kept.finger = MadeFingers::get().calibrated();
  kept.page = "inspect";
  kept.inspect.options.recording = MadeFingers::get().touched_pictures();
  kept.inspect.options.comparison = Comparison::kDifference;
  kept.inspect.options.with = {OtherMethod::kBody, {}, {}, 0, ball_file};
  kept.inspect.frame = 2;
  for (const bool is_there : {true, false}) {
    if (!is_there) fs::remove(ball_file);
    StudioOptions options;
    options.session_folder = folder / (is_there ? "there" : "removed");
    { SessionStore(options.session_folder).keep(kept); }
    Studio studio(options);
    studio.click("Go on with finger calibrated, recording touched");
    auto& place = *studio.window().findChild<InspectPage*>();
    ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }, 30000));
    EXPECT_EQ(place.frame_number(), 2U);
    EXPECT_EQ(place.options().comparison, Comparison::kDifference);
    EXPECT_TRUE(place.options().with == kept.inspect.options.with) << "the file may come back";
    if (is_there) {
      ASSERT_TRUE(
          wait_until([&] { return place.inspection().frame()->body_rms_mm.has_value(); }, 30000));
      EXPECT_LT(*place.inspection().frame()->body_rms_mm, 0.1);
    } else {
      EXPECT_TRUE(wait_until(
          [&] { return studio.problems().find("ball.stl") != std::string::npos; }, 30000))
          << studio.problems();
      EXPECT_FALSE(place.inspection().frame()->body_rms_mm);
    }
  }
}

}  // namespace
}  // namespace alltact::test
