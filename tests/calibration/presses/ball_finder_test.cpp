#include "calibration/presses/press.h"
#include "tests/support/made_press.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using namespace made;

Press flat_press(const cv::Mat& x, const MadeScene& scene) {
  Difference difference;
  difference.x = x;
  difference.flags = cv::Mat(x.size(), CV_8UC1, cv::Scalar(kMeasured));
  difference.face = whole_picture_runs(x.size());
  return {"picture_07", difference, scene.shape, 4.0};
}

cv::Mat noise(const cv::Size& size, double sd) {
  cv::Mat x(size, CV_32FC1);
  cv::theRNG().fill(x, cv::RNG::NORMAL, 0.0, sd);
  cv::GaussianBlur(x, x, {7, 7}, 1.0);
  return x;
}

/// Refused, with the picture's name, a reason holding `word`, and advice.
void expect_refusal(const Press& press, const MadeScene& scene, const std::string& word) {
  const auto ball = find_ball(press, scene.face);
  ASSERT_FALSE(ball.ok());
  EXPECT_EQ(ball.error().where.english(), press.name);
  EXPECT_NE(ball.error().what.english().find(word), std::string::npos)
      << ball.error().what.english();
  EXPECT_FALSE(ball.error().advice.empty());
}

TEST(BallFinder, FindsBallsOfAllDepthsAnywhereOnTheFlatFace) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const MadeScene scene = flat_scene();
  for (int i = 0; i < 12; ++i) {
    const Ball ball{100 + 200 * uniform(random), 90 + 120 * uniform(random),
                    3.0 + 2.0 * uniform(random), 0.3 + 0.9 * uniform(random)};
    const Contact contact{static_cast<Skin>(i % 4), i % 4 == 2 ? 0.9 : 0.15, 0.02 * (i % 3)};
    const Made made = make_press(scene, {}, contact, {ball}, 1.0, random);
    const auto guess = find_ball(made.press, scene.face);
    ASSERT_TRUE(guess.ok()) << guess.error().sentence();
    EXPECT_LT((guess->centre_mm - made.centre_mm).head<2>().norm(), 0.1);
    EXPECT_NEAR(guess->centre_mm.z(), made.centre_mm.z(), 0.6 * ball.depth_mm);
    EXPECT_FALSE(guess->cut_by_edge);
    EXPECT_GE(guess->rim_arc_deg, 340.0);
  }
}

TEST(BallFinder, FindsBallsOnAnInclinedFaceOffTheAxis) {
  std::mt19937 random(12);
  for (const double incline : {-20.0, 0.0, 25.0}) {
    const MadeScene scene = finger_scene(40.0, incline);
    const Made made = make_press(scene, {}, {}, {{330, 230, 4.0, 0.8}}, 1.0, random);
    const auto guess = find_ball(made.press, scene.face);
    ASSERT_TRUE(guess.ok()) << guess.error().sentence();
    // Brightness may follow the thickness along z or along the normal: before that is known, the
    // contact's middle may be anywhere between, layer * sin(incline) apart.
    EXPECT_LT((guess->centre_mm - made.centre_mm).norm(), 0.8) << incline;
  }
}

TEST(BallFinder, DiscCutByTheFacesEdgeIsSaidToBe) {
  std::mt19937 random(13);
  const MadeScene scene = flat_scene();
  const Made made = make_press(scene, {}, {}, {{200, 12, 4.0, 0.8}}, 1.0, random);
  const auto guess = find_ball(made.press, scene.face);
  ASSERT_TRUE(guess.ok()) << guess.error().sentence();
  EXPECT_TRUE(guess->cut_by_edge);
  EXPECT_LT(guess->rim_arc_deg, 300.0);
  EXPECT_LT((guess->centre_mm - made.centre_mm).head<2>().norm(), 0.2);
}

TEST(BallFinder, EmptyPicturesAreRefused) {
  const MadeScene scene = flat_scene();
  expect_refusal(flat_press(noise(scene.camera.size(), 0.02), scene), scene, "nothing on the face");
  expect_refusal(flat_press(cv::Mat::zeros(scene.camera.size(), CV_32FC1), scene), scene,
                 "nothing");
  cv::Mat unknown(scene.camera.size(), CV_32FC1, cv::Scalar(NAN));
  expect_refusal(flat_press(unknown, scene), scene, "hardly any pixel");
}

TEST(BallFinder, DarkGradientIsRefused) {
  const MadeScene scene = flat_scene();
  cv::Mat x = noise(scene.camera.size(), 0.01);
  for (int v = 0; v < x.rows; ++v)
    for (int u = 0; u < x.cols; ++u)
      x.at<float>(v, u) += 0.3F * static_cast<float>(u) / static_cast<float>(x.cols);
  const auto ball = find_ball(flat_press(x, scene), scene.face);
  ASSERT_FALSE(ball.ok());
  EXPECT_FALSE(ball.error().what.empty());
}

TEST(BallFinder, TwoContactsAreRefused) {
  std::mt19937 random(14);
  const MadeScene scene = flat_scene();
  const Made made =
      make_press(scene, {}, {}, {{110, 150, 4.0, 0.8}, {290, 150, 4.0, 0.7}}, 1.0, random);
  expect_refusal(made.press, scene, "two contacts");
}

TEST(BallFinder, TheDarkBorderOfAnEndIsNoContact) {
  // The face moved by less than a pixel: the border of its end is darker, more so than the ball.
  std::mt19937 random(14);
  const MadeScene scene = flat_scene();
  const std::vector<Ball> one{{210, 150, 4.0, 0.6}};
  const Made alone = make_press(scene, {}, {}, one, 1.0, random);
  const auto expected = find_ball(alone.press, scene.face);
  ASSERT_TRUE(expected.ok());
  for (const cv::Rect& border : {cv::Rect(0, 40, 8, 200), cv::Rect(392, 60, 8, 220)}) {
    Press press = alone.press;
    press.difference.x = alone.press.difference.x.clone();
    press.difference.x(border) += 0.5F;
    const auto ball = find_ball(press, scene.face);
    ASSERT_TRUE(ball.ok()) << ball.error().sentence();
    EXPECT_LT((ball->centre_mm - expected->centre_mm).norm(), 0.05);
  }
}

TEST(BallFinder, ABorderThatFadesInwardIsNoContact) {
  std::mt19937 random(14);
  const MadeScene scene = flat_scene();
  const Made alone = make_press(scene, {}, {}, {{210, 150, 4.0, 0.6}}, 1.0, random);
  const auto expected = find_ball(alone.press, scene.face);
  ASSERT_TRUE(expected.ok());
  Press press = alone.press;
  press.difference.x = alone.press.difference.x.clone();
  float more = 0.9F;
  for (int column = 399; column > 386; column -= 4, more *= 0.5F)
    press.difference.x(cv::Rect(column - 3, 20, 4, 260)) += more;
  const auto ball = find_ball(press, scene.face);
  ASSERT_TRUE(ball.ok()) << ball.error().sentence();
  EXPECT_LT((ball->centre_mm - expected->centre_mm).norm(), 0.05);
}

TEST(BallFinder, LettersAndBarsAreRefused) {
  const MadeScene scene = flat_scene();
  cv::Mat t = noise(scene.camera.size(), 0.01);
  t(cv::Rect(140, 90, 120, 30)) += 0.3F;
  t(cv::Rect(185, 120, 30, 90)) += 0.3F;
  expect_refusal(flat_press(t, scene), scene, "not a disc");
  cv::Mat bar = noise(scene.camera.size(), 0.01);
  bar(cv::Rect(150, 140, 110, 25)) += 0.3F;
  const auto ball = find_ball(flat_press(bar, scene), scene.face);
  EXPECT_FALSE(ball.ok());
}

TEST(BallFinder, DiscLargerThanTheBallIsRefused) {
  std::mt19937 random(15);
  const MadeScene scene = flat_scene();
  Made made = make_press(scene, {}, {}, {{200, 150, 20.0, 1.2}}, 1.0, random);
  made.press.ball_radius_mm = 4.0;
  expect_refusal(made.press, scene, "more than the ball's 4 mm");
}

TEST(BallFinder, ImpossibleRadiusIsRefused) {
  const MadeScene scene = flat_scene();
  Press press = flat_press(cv::Mat::zeros(scene.camera.size(), CV_32FC1), scene);
  for (const double radius : {0.0, -1.0, std::nan("")}) {
    press.ball_radius_mm = radius;
    EXPECT_FALSE(find_ball(press, scene.face).ok());
  }
}

}  // namespace
}  // namespace alltact
