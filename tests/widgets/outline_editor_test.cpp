// The ball's outline as hand and keys move it. Where it has to lie then is reckoned by other means:
// the line of sight through a pixel touches the ball.
#include "widgets/image/outline_editor.h"

#include "widgets/undo_step.h"

#include <QAccessible>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kRadiusMm = 4;

Camera camera(CameraModel model) {
  CameraParameters lens;
  lens.model = model;
  lens.width_px = 960;
  lens.height_px = 540;
  lens.fx_px = lens.fy_px = 523.9;
  lens.cx_px = 479.5;
  lens.cy_px = 269.5;
  if (model == CameraModel::kBrown) lens.distortion = {-0.12, 0.02, 0.001, -0.0005, 0};
  if (model == CameraModel::kFisheye) lens.distortion = {-0.02, 0.004, 0, 0};
  if (model == CameraModel::kOrthographic) lens.mm_per_px = 0.06;
  return Camera::create(lens).value();
}

Camera behind_window() {
  CameraParameters lens = camera(CameraModel::kPinhole).parameters();
  lens.port = FlatPort{};
  lens.port->gap_mm = 5;
  return Camera::create(lens).value();
}

/// How far the line of sight through a pixel passes outside the ball, mm: 0 on its outline.
double beside_mm(const Camera& camera, QPointF pixel, const Eigen::Vector3d& centre) {
  const Ray ray = camera.unproject({pixel.x(), pixel.y()}).value();
  const Eigen::Vector3d along = ray.direction.normalized();
  const Eigen::Vector3d from = centre - ray.origin_mm;
  return (from - from.dot(along) * along).norm() - kRadiusMm;
}

class OutlineGeometry : public testing::TestWithParam<const char*> {
 protected:
  static Camera make() {
    const std::string name = GetParam();
    if (name == "window") return behind_window();
    return camera(name == "pinhole"   ? CameraModel::kPinhole
                  : name == "brown"   ? CameraModel::kBrown
                  : name == "fisheye" ? CameraModel::kFisheye
                                      : CameraModel::kOrthographic);
  }
};
INSTANTIATE_TEST_SUITE_P(Camera, OutlineGeometry,
                         testing::Values("pinhole", "brown", "fisheye", "window", "orthographic"),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(OutlineGeometry, CentreGoesExactlyWhereItIsPut) {
  const ShownBall ball{make(), kRadiusMm, {7, -5, 52}, false};
  const QPointF wanted(611.37, 158.82);
  const auto centre = ball_moved_to(ball, wanted);
  ASSERT_TRUE(centre);
  EXPECT_DOUBLE_EQ(centre->z(), 52);
  const Eigen::Vector2d seen = ball.camera.project(*centre).value();
  EXPECT_NEAR(seen.x(), wanted.x(), 1e-6);
  EXPECT_NEAR(seen.y(), wanted.y(), 1e-6);
}

TEST_P(OutlineGeometry, SlidesAlongAnInclinedFace) {
  ShownBall ball{make(), kRadiusMm, {7, -5, 52}, false};
  ball.normal = Eigen::Vector3d(-std::sin(0.6), 0, std::cos(0.6));
  const auto centre = ball_moved_to(ball, {560.5, 270.25});
  ASSERT_TRUE(centre);
  EXPECT_NEAR(ball.normal.dot(*centre - ball.centre_mm), 0, 1e-9);
  EXPECT_NEAR((*ball.camera.project(*centre) - Eigen::Vector2d(560.5, 270.25)).norm(), 0, 1e-6);
  ball.normal = Eigen::Vector3d::UnitX();  // seen from its edge
  EXPECT_FALSE(ball_moved_to(ball, {479.5, 269.5}));
}

TEST_P(OutlineGeometry, RimGoesExactlyWhereItIsPutAndTheCentreStays) {
  const ShownBall ball{make(), kRadiusMm, {12, -7, 52}, false};
  const Eigen::Vector2d before = ball.camera.project(ball.centre_mm).value();
  const QPointF wanted(before.x() + 31.4, before.y() - 37.3);
  const auto centre = ball_with_rim_at(ball, wanted);
  if (!ball.camera.is_perspective()) {
    EXPECT_FALSE(centre) << "parallel rays see the same size at any distance";
    return;
  }
  ASSERT_TRUE(centre);
  EXPECT_NEAR(beside_mm(ball.camera, wanted, *centre), 0, 1e-9);
  const Eigen::Vector2d after = ball.camera.project(*centre).value();
  EXPECT_NEAR((after - before).norm(), 0, 1e-6);
}

TEST_P(OutlineGeometry, PlaceIsThatOfTheOutline) {
  const ShownBall ball{make(), kRadiusMm, {12, -7, 52}, false};
  const auto place = image_outline(ball);
  ASSERT_TRUE(place);
  EXPECT_GT(place->radius_px(), 20);
  EXPECT_NEAR(beside_mm(ball.camera, {place->right_u, place->centre.y()}, ball.centre_mm), 0, 2e-5);
}

TEST(OutlineGeometry, NothingIsPutBesideTheCameraOrOntoItsOwnCentre) {
  const ShownBall ball{camera(CameraModel::kPinhole), kRadiusMm, {0, 0, 52}, false};
  EXPECT_FALSE(ball_with_rim_at(ball, {479.5, 270}));
  const ShownBall near{camera(CameraModel::kPinhole), kRadiusMm, {0, 0, 6}, false};
  // A ball of this size that fills the picture would be around the lens.
  EXPECT_FALSE(ball_with_rim_at(near, {90000, 269.5}));
}

/// An editor whose ball can be undone, as a place does it.
class OutlineEditorTest : public testing::Test {
 protected:
  OutlineEditorTest() : grey_(540, 960, CV_8UC1, cv::Scalar(90)) {
    editor_.resize(960, 540);
    editor_.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&editor_));
    editor_.show_image(grey_, {});
    QObject::connect(&editor_, &OutlineEditor::ball_moved,
                     [this](const Eigen::Vector3d& before, const Eigen::Vector3d& after, int grip) {
                       undo_.push(new ValueChange<Eigen::Vector3d>(
                           [] { return QStringLiteral("move"); }, before, after,
                           [this](const Eigen::Vector3d& c) { put(c); }, grip));
                     });
    put({5, -4, 52});
    undo_.clear();
  }
  void put(const Eigen::Vector3d& centre) {
    editor_.set_ball(ShownBall{camera_, kRadiusMm, centre, true});
  }
  [[nodiscard]] ImageOutline place() const { return image_outline(*editor_.ball()).value(); }
  [[nodiscard]] QPoint on_screen(QPointF pixel) const {
    return editor_.transform().to_widget(pixel).toPoint();
  }
  void drag(QPoint from, QPoint to) {
    QTest::mousePress(&editor_, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&editor_, from + (to - from) * i / 5);
    QTest::mouseRelease(&editor_, Qt::LeftButton, {}, to);
  }
  void wheel(QPointF at, int notches, Qt::KeyboardModifiers modifiers = {}) {
    QWheelEvent event(at, editor_.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&editor_, &event);
  }

  cv::Mat grey_;
  Camera camera_ = camera(CameraModel::kBrown);
  OutlineEditor editor_;
  QUndoStack undo_;
};

TEST_F(OutlineEditorTest, DraggingTheCentreMovesItWithTheHandToAFractionOfAPixel) {
  for (int i = 0; i < 9; ++i) wheel(on_screen(place().centre), 1);  // five screen pixels each
  const double scale = editor_.transform().scale;
  ASSERT_GT(scale, 4);
  const ImageOutline before = place();
  const QPoint from = on_screen(before.centre) + QPoint(2, -1);  // beside the cross' middle
  drag(from, from + QPoint(7, -3));
  EXPECT_NEAR(place().centre.x() - before.centre.x(), 7 / scale, 1e-6);
  EXPECT_NEAR(place().centre.y() - before.centre.y(), -3 / scale, 1e-6);
  EXPECT_DOUBLE_EQ(editor_.ball()->centre_mm.z(), 52);
}

TEST_F(OutlineEditorTest, DraggingTheRimChangesTheSizeByTheHandsWay) {
  const ImageOutline before = place();
  const QPoint rim = on_screen({before.right_u, before.centre.y()});
  drag(rim, rim + QPoint(6, 0));
  EXPECT_NEAR(place().right_u - before.right_u, 6, 0.02);
  EXPECT_NEAR(place().centre.x(), before.centre.x(), 1e-6);
  EXPECT_LT(editor_.ball()->centre_mm.z(), 52) << "larger is nearer";
}

TEST_F(OutlineEditorTest, ADragIsOneStepToUndo) {
  const Eigen::Vector3d before = editor_.ball()->centre_mm;
  const QPoint from = on_screen(place().centre);
  drag(from, from + QPoint(20, 10));
  const Eigen::Vector3d first = editor_.ball()->centre_mm;
  drag(on_screen(place().centre), on_screen(place().centre) + QPoint(-5, 3));
  EXPECT_EQ(undo_.count(), 2);
  undo_.undo();
  EXPECT_EQ(editor_.ball()->centre_mm, first);
  undo_.undo();
  EXPECT_EQ(editor_.ball()->centre_mm, before);
  undo_.redo();
  EXPECT_EQ(editor_.ball()->centre_mm, first);
}

TEST_F(OutlineEditorTest, KeysMoveAndResizeByATenthOrByAPixel) {
  const ImageOutline before = place();
  QTest::keyClick(&editor_, Qt::Key_Right);
  QTest::keyClick(&editor_, Qt::Key_Up);
  EXPECT_NEAR(place().centre.x() - before.centre.x(), 0.1, 1e-6);
  EXPECT_NEAR(place().centre.y() - before.centre.y(), -0.1, 1e-6);
  QTest::keyClick(&editor_, Qt::Key_Left, Qt::ShiftModifier);
  QTest::keyClick(&editor_, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(place().centre.x() - before.centre.x(), -0.9, 1e-6);
  EXPECT_NEAR(place().centre.y() - before.centre.y(), 0.9, 1e-6);
  const double radius = place().radius_px();
  QTest::keyClick(&editor_, Qt::Key_PageUp);
  EXPECT_NEAR(place().radius_px() - radius, 0.1, 1e-3);
  QTest::keyClick(&editor_, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_NEAR(place().radius_px() - radius, -0.9, 1e-3);
  EXPECT_EQ(undo_.count(), 1) << "keys in one run are one step";
}

TEST_F(OutlineEditorTest, TheWheelResizesOverTheRimAndZoomsElsewhere) {
  const ImageOutline before = place();
  const QPointF rim = on_screen({before.right_u, before.centre.y()});
  wheel(rim, 3);
  EXPECT_NEAR(place().radius_px() - before.radius_px(), 0.3, 1e-3);
  wheel(rim, -1, Qt::ShiftModifier);
  EXPECT_NEAR(place().radius_px() - before.radius_px(), -0.7, 1e-3);
  const double scale = editor_.transform().scale;
  wheel({40, 40}, 1);
  EXPECT_GT(editor_.transform().scale, scale);
}

TEST_F(OutlineEditorTest, ElsewhereTheHandMovesThePicture) {
  for (int i = 0; i < 5; ++i) wheel({100, 100}, 1);
  const Eigen::Vector3d ball = editor_.ball()->centre_mm;
  const QPointF offset = editor_.transform().offset;
  drag({60, 60}, {90, 75});
  EXPECT_EQ(editor_.ball()->centre_mm, ball);
  EXPECT_NE(editor_.transform().offset, offset);
  const QPointF panned = editor_.transform().offset;
  QTest::keyClick(&editor_, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(editor_.ball()->centre_mm, ball);
  EXPECT_NE(editor_.transform().offset, panned);
}

TEST_F(OutlineEditorTest, TheMagnifierNeverHidesWhatIsMoved) {
  EXPECT_FALSE(editor_.is_magnifying());
  for (const Eigen::Vector3d& centre :
       {Eigen::Vector3d(0, 0, 52), Eigen::Vector3d(-40, -20, 52), Eigen::Vector3d(40, 20, 52),
        Eigen::Vector3d(38, -20, 30), Eigen::Vector3d(0, 0, 9)}) {
    put(centre);
    const QPoint hand = on_screen(place().centre);
    if (!editor_.rect().contains(hand)) continue;
    QTest::mousePress(&editor_, Qt::LeftButton, {}, hand);
    ASSERT_TRUE(editor_.is_magnifying());
    const QRectF loupe = editor_.magnifier();
    EXPECT_TRUE(QRectF(editor_.rect()).contains(loupe));
    EXPECT_FALSE(loupe.adjusted(-20, -20, 20, 20).contains(hand)) << centre.transpose();
    QTest::mouseRelease(&editor_, Qt::LeftButton, {}, hand);
    EXPECT_FALSE(editor_.is_magnifying());
  }
}

TEST_F(OutlineEditorTest, TheMagnifierShowsThePixelsUnderTheHand) {
  cv::Mat grey(540, 960, CV_8UC1, cv::Scalar(40));
  const ImageOutline at = place();
  const QPoint pixel(static_cast<int>(std::lround(at.centre.x())) + 4,
                     static_cast<int>(std::lround(at.centre.y())) + 4);
  grey.at<std::uint8_t>(pixel.y(), pixel.x()) = 240;
  editor_.show_image(grey, {});
  QTest::mousePress(&editor_, Qt::LeftButton, {}, on_screen(at.centre));
  const QRectF loupe = editor_.magnifier();
  const QImage image = editor_.grab(loupe.toAlignedRect()).toImage();
  int bright = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      bright += colour.red() == 240 && colour.green() == 240 && colour.blue() == 240 ? 1 : 0;
    }
  EXPECT_NEAR(bright, 100, 15) << "one picture pixel, ten by ten";
  QTest::mouseRelease(&editor_, Qt::LeftButton, {}, on_screen(at.centre));
}

TEST_F(OutlineEditorTest, TellsAScreenReaderWhereTheBallIs) {
  QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(&editor_);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->text(QAccessible::Name), QStringLiteral("Image with the ball's outline"));
  EXPECT_EQ(seen->role(), QAccessible::Graphic);
  put({0, 0, 52});
  EXPECT_EQ(seen->text(QAccessible::Value).toStdString(),
            "Centre u 479.5 px, v 269.5 px, radius 40.4 px; ball at x 0.00, y 0.00, z 52.00 mm");
  QTest::keyClick(&editor_, Qt::Key_Right);
  EXPECT_TRUE(seen->text(QAccessible::Value).startsWith(QStringLiteral("Centre u 479.6 px")));
}

TEST_F(OutlineEditorTest, WithoutABallItIsAPlainPicture) {
  editor_.set_ball(std::nullopt);
  QSignalSpy spy(&editor_, &OutlineEditor::ball_moved);
  drag({480, 270}, {500, 280});
  for (const Qt::Key key : {Qt::Key_Right, Qt::Key_PageUp, Qt::Key_Plus})
    QTest::keyClick(&editor_, key);
  EXPECT_EQ(spy.count(), 0);
  EXPECT_FALSE(editor_.is_magnifying());
  static_cast<void>(editor_.grab());
}

}  // namespace
}  // namespace alltact
