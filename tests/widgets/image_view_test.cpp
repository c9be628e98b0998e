// The picture view as hand and keys use it; where pixels lie is known from the definition.
#include "widgets/image/image_view.h"

#include "widgets/image/overlays.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

TEST(ImageTransform, FitsTheWholePictureInTheMiddle) {
  const auto fit = ImageTransform::fit({200, 100}, {400, 400});
  EXPECT_DOUBLE_EQ(fit.scale, 2);
  EXPECT_EQ(fit.covered({200, 100}), QRectF(0, 100, 400, 200));
  // The outer corner of the first pixel lies half a pixel before its centre.
  EXPECT_EQ(fit.to_widget({-0.5, -0.5}), QPointF(0, 100));
  EXPECT_EQ(fit.to_widget({0, 0}), QPointF(1, 101));
  EXPECT_EQ(fit.to_widget({199.5, 99.5}), QPointF(400, 300));
}

RC_GTEST_PROP(ImageTransform, GoesThereAndBack, ()) {
  const auto number = [](int low, int high) {
    return static_cast<double>(*rc::gen::inRange(low, high)) / 7;
  };
  const ImageTransform transform{number(1, 400), {number(-9999, 9999), number(-9999, 9999)}};
  const QPointF pixel(number(-999, 9999), number(-999, 9999));
  const QPointF back = transform.to_image(transform.to_widget(pixel));
  RC_ASSERT(std::hypot(back.x() - pixel.x(), back.y() - pixel.y()) < 1e-8);
}

RC_GTEST_PROP(ImageTransform, ZoomsAboutThePointer, ()) {
  const auto number = [](int low, int high) {
    return static_cast<double>(*rc::gen::inRange(low, high)) / 7;
  };
  const ImageTransform before{number(1, 400), {number(-9999, 9999), number(-9999, 9999)}};
  const QPointF pointer(number(0, 9999), number(0, 9999));
  const auto after = before.zoomed(number(1, 400), pointer);
  const QPointF difference = after.to_widget(before.to_image(pointer)) - pointer;
  RC_ASSERT(std::hypot(difference.x(), difference.y()) < 1e-6);
}

class ImageViewTest : public testing::Test {
 protected:
  ImageViewTest() : grey_(90, 160, CV_8UC1) {
    for (int v = 0; v < grey_.rows; ++v)
      for (int u = 0; u < grey_.cols; ++u)
        grey_.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>((u + v) % 256);
    view_.resize(640, 480);
    view_.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&view_));
    view_.show_image(grey_, {});
  }
  void hover(QPoint at) { QTest::mouseMove(&view_, at); }
  void wheel(QPointF at, int notches) {
    QWheelEvent event(at, view_.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view_, &event);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&view_, key, modifiers);
  }
  [[nodiscard]] QImage painted() { return view_.grab().toImage(); }

  cv::Mat grey_;
  ImageView view_;
};

TEST_F(ImageViewTest, FitsAtFirstAndAfterAnotherSize) {
  EXPECT_TRUE(view_.is_fitted());
  EXPECT_DOUBLE_EQ(view_.transform().scale, 4);
  key(Qt::Key_Plus);
  EXPECT_FALSE(view_.is_fitted());
  view_.show_image(grey_.clone(), {});
  EXPECT_FALSE(view_.is_fitted()) << "the zoom stays from frame to frame";
  view_.show_image(cv::Mat(45, 80, CV_8UC1, cv::Scalar(7)), {});
  EXPECT_TRUE(view_.is_fitted());
}

TEST_F(ImageViewTest, PaintsEveryPixelWhereItLies) {
  const QImage image = painted();
  // Not at the view's own edge, which shows that it has the focus.
  for (const QPoint pixel : {QPoint(2, 0), QPoint(157, 0), QPoint(2, 89), QPoint(80, 45)}) {
    const QPoint at = view_.transform().to_widget(pixel).toPoint();
    const int level = grey_.at<std::uint8_t>(pixel.y(), pixel.x());
    EXPECT_NEAR(qGray(image.pixel(at)), level, 1) << pixel.x() << ", " << pixel.y();
  }
}

TEST_F(ImageViewTest, DoesNotCopyThePicture) { EXPECT_EQ(view_.image().data, grey_.data); }

TEST_F(ImageViewTest, WheelZoomsAboutThePointer) {
  const QPointF pointer(200, 250);
  const QPointF before = view_.transform().to_image(pointer);
  wheel(pointer, 3);
  EXPECT_NEAR(view_.transform().scale, 4 * std::pow(1.2, 3), 1e-9);
  const QPointF after = view_.transform().to_image(pointer);
  EXPECT_NEAR(after.x(), before.x(), 1e-9);
  EXPECT_NEAR(after.y(), before.y(), 1e-9);
}

TEST_F(ImageViewTest, ZoomsDownToAPixelAndNotBeyondTheWhole) {
  for (int i = 0; i < 40; ++i) wheel({320, 240}, 1);
  EXPECT_DOUBLE_EQ(view_.transform().scale, 64);
  for (int i = 0; i < 60; ++i) wheel({320, 240}, -1);
  EXPECT_LE(view_.transform().scale, 4);
  EXPECT_GE(view_.transform().scale, 1 / view_.devicePixelRatioF());
}

TEST_F(ImageViewTest, KeysZoomFitAndShowTheOwnSize) {
  key(Qt::Key_Plus);
  EXPECT_DOUBLE_EQ(view_.transform().scale, 6);
  key(Qt::Key_Minus);
  EXPECT_DOUBLE_EQ(view_.transform().scale, 4);
  key(Qt::Key_1);
  EXPECT_DOUBLE_EQ(view_.transform().scale, 1 / view_.devicePixelRatioF());
  key(Qt::Key_0);
  EXPECT_TRUE(view_.is_fitted());
}

TEST_F(ImageViewTest, DraggingMovesThePictureWithTheHand) {
  for (int i = 0; i < 10; ++i) wheel({320, 240}, 1);
  const QPointF before = view_.transform().offset;
  QTest::mousePress(&view_, Qt::LeftButton, {}, {300, 200});
  QTest::mouseMove(&view_, {330, 190});
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, {330, 190});
  EXPECT_EQ(view_.transform().offset - before, QPointF(30, -10));
  QTest::mouseDClick(&view_, Qt::LeftButton, {}, {300, 200});
  EXPECT_TRUE(view_.is_fitted());
}

TEST_F(ImageViewTest, ArrowsMoveAndNeverLoseThePicture) {
  for (int i = 0; i < 10; ++i) wheel({320, 240}, 1);
  const double before = view_.transform().offset.x();
  key(Qt::Key_Right);
  EXPECT_DOUBLE_EQ(view_.transform().offset.x(), before - 40);
  for (int i = 0; i < 1000; ++i) key(Qt::Key_Right);
  EXPECT_NEAR(view_.transform().covered({160, 90}).right(), 640, 1e-6);
}

TEST_F(ImageViewTest, AReducedPictureLiesWhereItsTransformSays) {
  // Even slopes: a bilinear reduction leaves them as they are.
  const auto level_at = [](QPointF pixel) { return 10 + pixel.x() / 10 + pixel.y() / 40; };
  cv::Mat slope(1080, 1920, CV_8UC1);
  for (int v = 0; v < slope.rows; ++v)
    for (int u = 0; u < slope.cols; ++u)
      slope.at<std::uint8_t>(v, u) =
          static_cast<std::uint8_t>(std::lround(level_at(QPointF(u, v))));
  view_.show_image(slope, {});
  for (const QSize size : {QSize(640, 480), QSize(701, 397), QSize(333, 511), QSize(1500, 901)}) {
    view_.resize(size);
    view_.fit();
    for (int zooms = 0; zooms < 2; ++zooms) {
      ASSERT_LT(view_.transform().scale, 1);
      const QImage image = painted();
      const QRectF covered = view_.transform().covered({slope.cols, slope.rows});
      int seen = 0;
      // Not at the view's own edge, which shows that it has the focus.
      for (int y = 3; y + 3 < image.height(); y += 3)
        for (int x = 3; x + 3 < image.width(); x += 3) {
          const QPointF centre(x + 0.5, y + 0.5);
          if (!covered.adjusted(2, 2, -2, -2).contains(centre)) continue;
          const double level = level_at(view_.transform().to_image(centre));
          ASSERT_NEAR(qGray(image.pixel(x, y)), level, 1.6) << x << ", " << y;
          ++seen;
        }
      EXPECT_GT(seen, 1000);
      view_.zoom_by(1.27);
    }
  }
}

TEST_F(ImageViewTest, APartOfALayerLiesWhereThePictureShowsIt) {
  const cv::Rect part(300, 520, 640, 128);
  const cv::Mat red(part.size(), CV_8UC4, cv::Scalar(0, 0, 255, 255));
  view_.show_image(cv::Mat(1080, 1920, CV_8UC1, cv::Scalar(0)),
                   {layer_overlay(red, part.tl()), layer_overlay(cv::Mat())});
  for (const QSize size : {QSize(640, 480), QSize(701, 397), QSize(2500, 1500)}) {
    view_.resize(size);
    view_.fit();
    const QImage image = painted();
    const QRectF shown(view_.transform().to_widget({part.x - 0.5, part.y - 0.5}),
                       view_.transform().to_widget({part.br().x - 0.5, part.br().y - 0.5}));
    int wrong = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QPointF centre(x + 0.5, y + 0.5);
        const bool is_inside = shown.adjusted(1, 1, -1, -1).contains(centre),
                   is_outside = !shown.adjusted(-1, -1, 1, 1).contains(centre);
        const QRgb here = image.pixel(x, y);
        wrong += is_inside && (qRed(here) < 200 || qGreen(here) > 50) ? 1 : 0;
        wrong += is_outside && qRed(here) > qGreen(here) + 50 ? 1 : 0;
      }
    EXPECT_EQ(wrong, 0) << size.width();
  }
}

TEST_F(ImageViewTest, ProbeFollowsPointerAndKeys) {
  QSignalSpy spy(&view_, &ImageView::probe_changed);
  hover(view_.transform().to_widget({12, 34}).toPoint());
  EXPECT_EQ(view_.probe(), QPoint(12, 34));
  EXPECT_GT(spy.count(), 0);
  key(Qt::Key_Right, Qt::ShiftModifier);  // takes over where the pointer is...
  EXPECT_EQ(view_.probe(), QPoint(12, 34));
  key(Qt::Key_Right, Qt::ShiftModifier);  // ...and moves from there
  key(Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_EQ(view_.probe(), QPoint(13, 35));
  for (int i = 0; i < 300; ++i) key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(view_.probe(), QPoint(0, 35));
  key(Qt::Key_Escape);
  EXPECT_EQ(view_.probe(), QPoint(12, 34)) << "the pointer is still there";
}

TEST_F(ImageViewTest, HasNoProbeOutsideThePicture) {
  hover({320, 5});  // above the picture
  EXPECT_FALSE(view_.probe());
}

TEST_F(ImageViewTest, SaysWhyThereIsNoPicture) {
  view_.show_message(QStringLiteral("Nothing is open."));
  EXPECT_TRUE(view_.image().empty());
  EXPECT_FALSE(view_.probe());
  EXPECT_EQ(view_.accessibleDescription(), QStringLiteral("Nothing is open."));
  key(Qt::Key_Plus);
  wheel({100, 100}, 1);
  static_cast<void>(painted());
}

TEST_F(ImageViewTest, SeenAndEstimatedMarkersDifferInShape) {
  const auto picture_of = [this](bool is_seen) {
    view_.show_image(cv::Mat(90, 160, CV_8UC1, cv::Scalar(0)),
                     {markers_overlay({{80, 45, is_seen, 0.1}, {80, 80, is_seen, 0.1}})});
    QImage image = painted();
    // Colour taken away: what is left is shape.
    return image.convertToFormat(QImage::Format_Grayscale8)
        .copy(QRect(view_.transform().to_widget({80, 45}).toPoint() - QPoint(50, 50),
                    QSize(100, 100)));
  };
  const QImage seen = picture_of(true), estimated = picture_of(false);
  int different = 0;
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x)
      different += (qGray(seen.pixel(x, y)) > 100) != (qGray(estimated.pixel(x, y)) > 100) ? 1 : 0;
  EXPECT_GT(different, 150);
}

}  // namespace
}  // namespace alltact
