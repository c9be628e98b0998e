// What is forecast of presses is what calibrating with them gives.
#include "calibration/finger/calibrate_presses.h"
#include "tests/support/made_press.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;
using testing::HasSubstr;

struct Forecast {
  Finger finger;
  std::vector<MeasuredPress> presses;
  CalibrationInputs inputs;
  std::vector<Press> as_solved;
  std::vector<Eigen::Vector3d> centres_mm;
};

Forecast four_presses() {
  Forecast made;
  const made::MadeScene scene = finger_scene(40.0, 20.0);
  made.finger.camera = scene.camera.parameters();
  made.finger.face = scene.face;
  made.inputs.press_set.ball_radius_mm = 4.0;
  std::mt19937 random(17);
  for (int i = 0; i < 4; ++i) {
    const Ball ball{340.0 + 80 * i, 225.0 + 25 * i, 4.0, 0.5 + 0.18 * i};
    Made one =
        make_press(scene, {}, {Skin::kHertz, 0, 0.02}, {ball}, 1.0, random, fmt::format("p{}", i));
    made.as_solved.push_back(one.press);
    made.as_solved.back().ball_radius_mm = 4.0;
    made.centres_mm.push_back(one.centre_mm);
    MeasuredPress press;
    press.name = one.press.name;
    press.press = std::move(one.press);
    press.press->ball_radius_mm = 0;  // told by what is said
    Reference reference;
    reference.image =
        ReferenceImage(cv::Mat(press.press->difference.x.size(), CV_32FC1, cv::Scalar(150)));
    press.reference = reference;
    made.presses.push_back(std::move(press));
  }
  return made;
}

TEST(ForecastCalibration, IsTheSameSolutionToTheBit) {
  const Forecast made = four_presses();
  const auto forecast = forecast_calibration(made.finger, {}, made.presses, made.inputs, Job());
  ASSERT_TRUE(forecast) << forecast.error().sentence();
  const auto camera = Camera::create(made.finger.camera).value();
  const auto solved = calibrate(made.as_solved, camera, made.finger.face, {}, Job());
  ASSERT_TRUE(solved) << solved.error().sentence();
  EXPECT_EQ(forecast->calibration.held_out_mm, solved->held_out_mm);
  EXPECT_EQ(forecast->calibration.spread_mm, solved->spread_mm);
  ASSERT_EQ(forecast->calibration.balls.size(), solved->balls.size());
  for (std::size_t i = 0; i < solved->balls.size(); ++i)
    EXPECT_EQ(forecast->calibration.balls[i].centre_mm, solved->balls[i].centre_mm);
  EXPECT_GE(forecast->verdict.error_mm, solved->held_out_mm);
}

TEST(ForecastCalibration, TakesWhatIsSaidOfPressesNow) {
  Forecast made = four_presses();
  PressNote note;
  note.excluded = "glove";
  made.inputs.press_set.say("p2", note);
  const auto without = forecast_calibration(made.finger, {}, made.presses, made.inputs, Job());
  ASSERT_TRUE(without) << without.error().sentence();
  EXPECT_EQ(without->calibration.balls.size(), 3U);
  for (const char* name : {"p0", "p1", "p2", "p3"}) made.inputs.press_set.say(name, note);
  const auto none = forecast_calibration(made.finger, {}, made.presses, made.inputs, Job());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().what.english(), HasSubstr("no press can be used"));
}

TEST(FitOfPress, IsLeastWhereTheBallIsAndTellsWhichWayItIsOff) {
  Forecast made = four_presses();
  const auto forecast =
      forecast_calibration(made.finger, {}, made.presses, made.inputs, Job()).value();
  const Press& press = made.as_solved[1];
  const auto fit_at = [&](const Eigen::Vector3d& centre) {
    return fit_of_press(press, made.finger.face, forecast.calibration.mapping, centre);
  };
  const Eigen::Vector3d centre = made.centres_mm[1];
  const auto there = fit_at(centre);
  ASSERT_TRUE(there);
  EXPECT_LT(there->error_mm, 0.03);
  EXPECT_GE(there->side_px, 2);
  EXPECT_GT(there->residuals.samples.size(), 100U);
  const auto mean = [](const PressFit& fit) {
    double sum = 0;
    int count = 0;
    for (const ResidualSample& sample : fit.residuals.samples)
      if (sample.rim <= kInnerRim) sum += sample.residual_mm, ++count;
    return sum / count;
  };
  // A ball drawn 0.1 mm too deep: everywhere the mapping seems to read too shallow.
  const auto deep = fit_at(centre - Eigen::Vector3d(0, 0, 0.1));
  ASSERT_TRUE(deep);
  EXPECT_LT(mean(*deep), mean(*there) - 0.05);
  const auto shallow = fit_at(centre + Eigen::Vector3d(0, 0, 0.1));
  ASSERT_TRUE(shallow);
  EXPECT_GT(mean(*shallow), mean(*there) + 0.05);
  EXPECT_GT(fit_at(centre + Eigen::Vector3d(0.5, 0, 0))->error_mm, 2 * there->error_mm);
  EXPECT_FALSE(fit_at(centre + Eigen::Vector3d(300, 0, 0))) << "off the picture";
}

}  // namespace
}  // namespace alltact
