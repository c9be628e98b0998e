// What only a screen with OpenGL shows of the place Inspect: the probe in 3D against the depth that
// is exported, and pictures to look at.
#include "tests/studio/standing_view.h"
#include "tests/studio/two_fingers.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/inspect/point_readings.h"

#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QMenu>
#include <set>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class InspectIn3DView : public testing::Test {
 protected:
  void SetUp() override {
    if (!VtkView::is_supported()) GTEST_SKIP() << "needs a screen with OpenGL: xvfb-run";
    StudioOptions options;
    options.finger = MadeFingers::get().calibrated();
    studio_.emplace(options);
    studio_->window().go_to("inspect");
  }
  InspectPage& place() { return *studio_->window().findChild<InspectPage*>(); }
  const InspectedFrame& frame() { return *place().inspection().frame(); }
  bool open(const std::filesystem::path& recording) {
    place().open(recording);
    return wait_for_standing_view(*studio_);
  }
  FacePane& view() { return *studio_->window().findChild<FacePane*>(); }
  void save(const std::string& name) {
    QTest::qWait(400);
    std::filesystem::create_directories(ALLTACT_SCREENS);
    studio_->window().grab().save(
        QString::fromStdString(std::string(ALLTACT_SCREENS) + "/" + name + ".png"));
  }
  std::optional<Studio> studio_;
};

TEST_F(InspectIn3DView, TellsUnderThePointerTheDepthThatIsExported) {
  ASSERT_TRUE(open(MadeFingers::get().touched_pictures()));
  const cv::Mat& depth_mm = frame().result.depth->depth_mm;  // what the command line writes
  const QRect room = view().rect();
  int told = 0;
  for (int k = 0; k < 40; ++k) {
    const QPoint at(room.width() * (10 + 2 * k) / 100, room.height() * (30 + k % 20) / 100);
    const double ratio = view().devicePixelRatioF();
    const auto pixel = view().scene().pixel_at(at.x() * ratio, at.y() * ratio);
    QTest::mouseMove(&view(), at);
    const auto* label = studio_->find<QLabel>(QStringLiteral("Under the pointer"));
    const auto is_told = [&](const QString& beginning) {
      return wait_until([&] { return label->text().startsWith(beginning); }, 3000);
    };
    if (!pixel) {
      EXPECT_TRUE(is_told(QStringLiteral("Point at the face"))) << label->text().toStdString();
      continue;
    }
    const float depth = depth_mm.at<float>(cv::Point(nearest_pixel(*pixel)));
    if (!std::isfinite(depth)) continue;
    ++told;
    const float without_sign = std::abs(depth) < 0.005F ? 0.F : depth;  // no "-0.00"
    EXPECT_TRUE(is_told(QStringLiteral("depth ") + QLocale().toString(without_sign, 'f', 2)))
        << label->text().toStdString() << " instead of " << depth;
  }
  EXPECT_GT(told, 8);
}

/// As it is seen, with its colour bar; the right button sets point B and opens no menu.
TEST_F(InspectIn3DView, IsCopied) {
  ASSERT_TRUE(open(MadeFingers::get().touched_pictures()));
  QGuiApplication::clipboard()->clear();
  QTest::keyClick(&view(), Qt::Key_C, Qt::ControlModifier);
  const QImage copied = QGuiApplication::clipboard()->image();
  EXPECT_EQ(copied.size(), view().size() * view().devicePixelRatioF());
  std::set<QRgb> colours;
  for (int y = 0; y < copied.height(); y += 4)
    for (int x = 0; x < copied.width(); x += 4) colours.insert(copied.pixel(x, y));
  EXPECT_GT(colours.size(), 50U);
  QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, view().mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(&view(), &event);
  EXPECT_EQ(view().findChild<QMenu*>(), nullptr);
}

TEST_F(InspectIn3DView, TheFacesRimHasItsNeighboursDepth) {
  ASSERT_TRUE(open(MadeFingers::get().touched_pictures()));
  const cv::Mat& depth_mm = frame().surface->depth_mm;
  for (const int row : {0, depth_mm.rows - 1}) {
    const cv::Mat rim = depth_mm.row(row);
    EXPECT_GT(cv::countNonZero(rim == rim), 0.97 * depth_mm.cols) << row;
  }
}

TEST_F(InspectIn3DView, TheFirst3DViewDoesNotMakeTheWindowAnew) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  studio_.emplace(options);
  const WId before = studio_->window().winId();
  studio_->window().go_to("inspect");
  ASSERT_TRUE(open(MadeFingers::get().touched_pictures()));
  EXPECT_EQ(studio_->window().winId(), before) << "it is black until it is drawn again";
}

TEST_F(InspectIn3DView, AClickPutsAPointThatStaysOnTheFinger) {
  ASSERT_TRUE(open(TwoFingers::get().left_video()));
  const auto middle = view().scene().window_pixel_of({450, 270});
  ASSERT_TRUE(middle);
  const double ratio = view().devicePixelRatioF();
  const QPoint at(static_cast<int>(middle->x / ratio), static_cast<int>(middle->y / ratio));
  QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(place().options().a);
  // A pointer stands on whole pixels of the screen: it is off by less than one of them, which on a
  // face seen at a slant is several of the camera's.
  double camera_pixels = 0;
  for (const QPoint step : {QPoint(1, 0), QPoint(0, 1), QPoint(1, 1), QPoint(-1, 1)}) {
    const auto there =
        view().scene().window_pixel_of({450 + 20.0 * step.x(), 270 + 20.0 * step.y()});
    ASSERT_TRUE(there);
    camera_pixels = std::max(camera_pixels, std::sqrt(2.0) * 20 * std::hypot(step.x(), step.y()) /
                                                (cv::norm(*there - *middle) / ratio));
  }
  RecordProperty("camera_pixels_per_screen_pixel", std::to_string(camera_pixels));
  EXPECT_LT(camera_pixels, 8);
  EXPECT_LT(cv::norm(*pixel_of(frame(), place().options().a) - cv::Point2d(450, 270)),
            1 + camera_pixels);
}

/// Light, dark and high contrast, small and large: to look at.
TEST_F(InspectIn3DView, Pictures) {
  ASSERT_TRUE(open(MadeFingers::get().touched_pictures()));
  ASSERT_TRUE(wait_until([&] { return place().inspection().summaries().size() == 6; }, 20000));
  for (const char* button : {"deepest", "across"})
    place().findChild<QPushButton*>(QLatin1String(button))->click();
  ProgramAppearance appearance;
  for (const auto& [size, name] : {std::pair{QSize(1024, 700), "1024"},
                                   {QSize(1280, 800), "1280"},
                                   {QSize(1440, 900), "1440"}})
    for (const auto& [theme, look] : {std::pair{Theme::kLight, "light"}, {Theme::kDark, "dark"}}) {
      appearance.apply({theme, QStringLiteral("en")});
      studio_->window().resize(size);
      save(std::string("inspect_3d_") + name + "_" + look);
    }
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  studio_->window().resize(1280, 800);
  InspectOptions options = place().options();
  options.scene.exaggeration = 5;
  place().restore(options, 0);
  for (const Viewpoint viewpoint : {Viewpoint::kCamera, Viewpoint::kOutside, Viewpoint::kSide}) {
    options.viewpoint = viewpoint;
    place().restore(options, 0);
    save("inspect_3d_from_" + std::to_string(static_cast<int>(viewpoint)));
  }
  options.viewpoint = Viewpoint::kTilted;
  options.comparison = Comparison::kDifference;
  place().restore(options, 0);
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }, 20000));
  save("inspect_3d_difference");
  options.comparison = Comparison::kSideBySide;
  options.with = {OtherMethod::kSetting, "smoothing-px", "0"};
  place().restore(options, 0);
  ASSERT_TRUE(wait_until([&] { return frame().other.has_value(); }, 20000));
  save("inspect_3d_beside");
  options.comparison = Comparison::kNone;
  place().restore(options, 0);
  studio_->window().open_finger(MadeFingers::get().described());
  ASSERT_TRUE(wait_until([&] { return frame().bare.has_value(); }, 20000));
  save("inspect_3d_uncalibrated");
}

}  // namespace
}  // namespace alltact::test
