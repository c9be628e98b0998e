// The source paper's circle on presses whose ball is known.
#include "calibration/finger/paper_pipeline.h"
#include "calibration/joint/calibrate.h"
#include "calibration/joint/outline_methods.h"
#include "tests/support/made_press.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

Result<SearchedCircle> searched(const Press& press, const MadeScene& scene) {
  const auto dark = dark_circle(press, scene.camera);
  if (!dark) return dark.error();
  return search_circle(press, *dark, samples_inside(press, scene.face, *dark), scene.camera,
                       scene.face);
}

/// Skin that lies on the ball up to the rim, and hardly any noise: what the paper takes for
/// granted.
TEST(CircleSearch, FindsTheKnownBallInPerspective) {
  std::mt19937 random(5);
  const MadeScene scene = finger_scene(60.0, 25.0);
  for (const double depth_mm : {0.6, 0.9}) {
    const Made made =
        make_press(scene, {0.6, 0.02}, {}, {{470, 280, 4.0, depth_mm}}, 0.02, random, "p");
    const auto found = searched(made.press, scene);
    ASSERT_TRUE(found.ok()) << found.error().sentence();
    EXPECT_LT((found->ball_mm - made.centre_mm).norm(), 0.15)
        << found->ball_mm.transpose() << " for " << made.centre_mm.transpose();
    EXPECT_LT(std::abs(found->constant_mm), 1e-3);
    // On the optical axis the circle is the ball's outline: R / |c| is the sine of its half angle.
    const auto ball = ball_of_circle(found->circle, scene.camera, 4.0, 0.0);
    ASSERT_TRUE(ball);
    EXPECT_LT((*ball - found->ball_mm).norm(), 1e-9);
  }
}

TEST(CircleSearch, FindsTheKnownBallOnAFlatSensor) {
  std::mt19937 random(6);
  const MadeScene scene = flat_scene();
  const Made made = make_press(scene, {0.6, 0.02}, {}, {{190, 140, 4.0, 0.8}}, 0.02, random, "p");
  const auto found = searched(made.press, scene);
  ASSERT_TRUE(found.ok()) << found.error().sentence();
  EXPECT_LT((found->ball_mm - made.centre_mm).norm(), 0.1);
  EXPECT_LT(std::abs(found->constant_mm), 1e-3);
}

TEST(CircleSearch, ACircleOnTheAxisIsTheBallItIsDrawnFrom) {
  const MadeScene scene = finger_scene(60.0, 0.0);
  const CameraParameters& lens = scene.camera.parameters();
  const double z = 70.0, radius = 3.0;
  const double size = lens.fy_px * radius / std::sqrt(z * z - radius * radius);
  const auto ball = ball_of_circle({{lens.cx_px, lens.cy_px}, size, 0.0}, scene.camera, radius, 0);
  ASSERT_TRUE(ball);
  EXPECT_LT((*ball - Eigen::Vector3d(0, 0, z)).norm(), 1e-9);
}

TEST(CircleSearch, ThinDarkLinesAreNoDisc) {
  std::mt19937 random(15);
  const MadeScene scene = flat_scene();
  Made made = make_press(scene, {}, {}, {{200, 150, 4.0, 0.6}}, 1.0, random);
  // As a reference of nearly the same pose leaves along the face's edges.
  made.press.difference.x(cv::Rect(20, 20, 360, 7)) += 0.4F;
  made.press.difference.x(cv::Rect(20, 270, 360, 7)) += 0.4F;
  const auto dark = dark_circle(made.press, scene.camera);
  ASSERT_TRUE(dark.ok()) << dark.error().sentence();
  EXPECT_LT((dark->centre - Eigen::Vector2d(200, 150)).norm(), 1.5);
}

TEST(CircleSearch, NothingPressedIsASentence) {
  std::mt19937 random(16);
  const MadeScene scene = flat_scene();
  const Made made = make_press(scene, {}, {}, {}, 0.2, random, "empty");
  const auto dark = dark_circle(made.press, scene.camera);
  ASSERT_FALSE(dark.ok());
  EXPECT_NE(dark.error().sentence().find("empty"), std::string::npos);
  CalibrationSettings settings;
  settings.method = CalibrationMethod::kPaper;
  const auto none = calibrate({made.press}, scene.camera, scene.face, settings, Job{});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().what.english().find("none of 1 presses"), std::string::npos);
}

/// The mapping at zero difference is zero, and where the skin is as the paper takes it, right.
TEST(CircleSearch, TheMappingHasNoConstant) {
  std::mt19937 random(17);
  const MadeScene scene = finger_scene(60.0, 25.0);
  const Layer layer{0.6, 0.02};
  std::vector<Press> presses;
  for (const double depth_mm : {0.5, 0.7, 0.9})
    presses.push_back(make_press(scene, layer, {}, {{400 + 100 * depth_mm, 290, 4.0, depth_mm}},
                                 0.02, random, fmt::format("p{}", depth_mm))
                          .press);
  CalibrationSettings settings;
  settings.method = CalibrationMethod::kPaper;
  const auto made = calibrate(presses, scene.camera, scene.face, settings, Job{});
  ASSERT_TRUE(made.ok()) << made.error().sentence();
  const Mapping mapping = Mapping::create(made->mapping).value();
  EXPECT_EQ(mapping.depth_mm(0.0), 0.0);
  for (const double x : {0.1, 0.2, 0.3})
    EXPECT_NEAR(mapping.depth_mm(x), layer.depth_at(x), 0.15) << x;
}

}  // namespace
}  // namespace alltact
