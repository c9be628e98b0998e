#include "widgets/calibrating/press_list.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// 2000 x 1000 px with a dark disc of 20 px about (1500, 700): to find in a list it must be cut
/// out.
constexpr int kDiscU = 1500, kDiscV = 700, kDisc_px = 20;

cv::Mat pressed_picture() {
  cv::Mat grey(1000, 2000, CV_8UC1, cv::Scalar(200));
  for (int v = kDiscV - kDisc_px; v <= kDiscV + kDisc_px; ++v)
    for (int u = kDiscU - kDisc_px; u <= kDiscU + kDisc_px; ++u)
      if (std::hypot(u - kDiscU, v - kDiscV) <= kDisc_px) grey.at<uchar>(v, u) = 20;
  return grey;
}

/// A ball that is seen with a radius of 30 px there.
ShownBall ball_over_the_disc() {
  CameraParameters parameters;
  parameters.model = CameraModel::kPinhole;
  parameters.width_px = 2000;
  parameters.height_px = 1000;
  parameters.fx_px = parameters.fy_px = 1000;
  parameters.cx_px = 999.5;
  parameters.cy_px = 499.5;
  const double z = 133;
  return {Camera::create(parameters).value(),
          4.0,
          {(kDiscU - 999.5) / 1000 * z, (kDiscV - 499.5) / 1000 * z, z},
          true,
          Eigen::Vector3d::UnitZ()};
}

int dark_share_percent(const QImage& image) {
  int dark = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) dark += qGray(image.pixel(x, y)) < 60 ? 1 : 0;
  return 100 * dark / (image.width() * image.height());
}

TEST(PressThumbnail, IsCutAroundTheBall) {
  const QSize size = PressThumbnails::size();
  const cv::Mat grey = pressed_picture();
  const QImage whole = press_thumbnail(grey, std::nullopt, size, 1);
  const QImage cut = press_thumbnail(grey, ball_over_the_disc(), size, 1);
  EXPECT_EQ(cut.size(), size);
  // Of the whole picture the disc is less than a thousandth: a pixel or two.
  EXPECT_EQ(dark_share_percent(whole.copy(1, 5, 110, 50)), 0);
  EXPECT_GE(dark_share_percent(cut), 8);
  EXPECT_LT(qGray(cut.pixel(size.width() / 2, size.height() / 2)), 60) << "in the middle";
}

TEST(PressThumbnail, ShowsTheOutline) {
  const QImage cut = press_thumbnail(pressed_picture(), ball_over_the_disc(), {112, 63}, 2);
  EXPECT_EQ(cut.size(), QSize(224, 126));
  int yellow = 0;
  for (int y = 0; y < cut.height(); ++y)
    for (int x = 0; x < cut.width(); ++x) {
      const QColor here = cut.pixelColor(x, y);
      yellow += here.red() > 200 && here.blue() < 130 ? 1 : 0;
    }
  EXPECT_GT(yellow, 200) << "a ring of 2.8 px and 260 px around";
}

TEST(PressThumbnail, ABallAtTheEdgeIsCutThereAndNothingElseIsDrawn) {
  ShownBall ball = ball_over_the_disc();
  ball.centre_mm.x() += (1990 - kDiscU) / 1000.0 * ball.centre_mm.z();
  const QImage cut = press_thumbnail(pressed_picture(), ball, {112, 63}, 1);
  EXPECT_EQ(qGray(cut.pixel(111, 31)), 0) << "beside the picture";
  EXPECT_GT(qGray(cut.pixel(10, 31)), 150) << "in it";
}

TEST(PressThumbnail, ABallThatIsOutsideLeavesTheWholePicture) {
  ShownBall ball = ball_over_the_disc();
  ball.centre_mm.x() += 500;
  EXPECT_EQ(press_thumbnail(pressed_picture(), ball, {112, 63}, 1).size(), QSize(112, 63));
}

TEST(RefusalWord, IsShort) {
  for (const Message& what :
       {en::say("only specks are dark, none larger than {} pixels", 9),
        en::say("the middle of the dark disc is outside the face"),
        en::say("two contacts were found, the second with {:.0f} % of the first", 30.0),
        en::say("something that nobody has thought of so far, told at great length")}) {
    const QString word = refusal_word(Error{what, "", ""});
    EXPECT_FALSE(word.isEmpty());
    EXPECT_LE(word.size(), 24) << word.toStdString();
  }
  EXPECT_EQ(
      refusal_word(Error{en::say("only specks are dark, none larger than {} pixels", 9), "", ""}),
      "only specks");
}

}  // namespace
}  // namespace alltact
