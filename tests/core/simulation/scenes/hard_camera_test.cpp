// The hard cases of the lens, the sensor and the way to the computer show what they say.
#include "tests/core/simulation/scenes/shipped_scene.h"

#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

TEST(ShippedScenes, HardAutomaticExposure) {
  const ShippedScene scene("hard_automatic_exposure");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const Plan locked = scene.plan({ALLTACT_BARE, "automatic-exposure"});
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    EXPECT_NEAR(mean_of(plan.render(frame)), 60, 1e-3) << frame;
    EXPECT_EQ(plan.effects(frame).size(), frame == 0 ? 5U : 6U);
  }
  for (int frame = 1; frame < plan.frame_count(); ++frame)
    EXPECT_LT(mean_of(locked.render(frame)), 0.98 * mean_of(locked.render(0))) << frame;
}

TEST(ShippedScenes, HardGamma) {
  const ShippedScene scene("hard_gamma");
  const cv::Mat_<float> tones = scene.plan({ALLTACT_BARE}).render(0),
                        light = scene.plan({ALLTACT_BARE, "gamma"}).render(0);
  for (int v = 5; v < tones.rows; v += 20)
    for (int u = 5; u < tones.cols; u += 20)
      EXPECT_NEAR(tones(v, u), 255 * std::pow(light(v, u) / 255, 1 / 2.2), 0.01);
  EXPECT_NEAR(255 * std::pow(0.5, 1 / 2.2), 186, 0.5);
}

TEST(ShippedScenes, HardPoorSensor) {
  const ShippedScene scene("hard_poor_sensor");
  const Plan plan = scene.plan();
  const cv::Mat image = plan.render(0), next = plan.render(1);
  const cv::Rect beside(900, 250, 60, 40);  // nothing but black
  EXPECT_NEAR(mean_of(image(beside)), 4, 0.4);
  const cv::Mat_<float> light =
      scene.plan({ALLTACT_BARE, "fixed-pattern", "shot", "row-noise", "black-level", "dead-pixels"})
          .render(0);
  cv::Mat off;
  image.convertTo(off, CV_32F);
  off -= light;
  cv::Scalar mean, sd;
  const cv::Rect bright(100, 200, 200, 150);
  cv::meanStdDev(off(bright), mean, sd);
  // Read 1, rows 0.7, grains 0.05 I, pixels 0.01 I and 0.5, of I = 170; some pixels are stuck.
  const double level = mean_of(light(bright));
  const double expected = std::sqrt(1 + 0.49 + 0.05 * level + 1e-4 * level * level + 0.25);
  EXPECT_GT(sd[0], 0.9 * expected);
  EXPECT_LT(sd[0], 1.6 * expected);
  // The same pixels are stuck in both frames.
  const cv::Mat stuck = (image == 255) & (next == 255);
  EXPECT_NEAR(cv::countNonZero(stuck), 0.0002 * 960 * 540, 45);
}

// Across the finger's lower edge, where it lies within the picture.
double edge_width_px(const cv::Mat_<float>& light, int u, int half_px) {
  const double z = [&] {
    const double slope = std::tan(34 * std::numbers::pi / 180), x = (u - 479.5) / 523.9;
    return (28 + 25 * slope) / (1 - x * slope);  // the straight face in column u
  }();
  const int edge = static_cast<int>(std::lround(269.5 + 12 * 523.9 / z));
  std::vector<float> values;
  for (int v = edge - half_px; v <= std::min(edge + half_px, light.rows - 1); ++v)
    values.push_back(light(v, u));
  return step_width_px(values);
}

TEST(ShippedScenes, HardDefocusAtTheBase) {
  const ShippedScene scene("hard_defocus_at_the_base");
  const cv::Mat_<float> light = scene.plan({ALLTACT_BARE}).render(0);
  EXPECT_GT(edge_width_px(light, 60, 22), 8);
  EXPECT_LT(edge_width_px(light, 840, 12), 3);
}

TEST(ShippedScenes, HardDefocusAtTheTip) {
  const ShippedScene scene("hard_defocus_at_the_tip");
  const cv::Mat_<float> light = scene.plan({ALLTACT_BARE}).render(0);
  EXPECT_LT(edge_width_px(light, 60, 22), 3);
  EXPECT_GT(edge_width_px(light, 840, 22), 8);
}

TEST(ShippedScenes, HardFastBending) {
  const ShippedScene scene("hard_fast_bending");
  const Plan plan = scene.plan({ALLTACT_BARE});
  EXPECT_NEAR(plan.truth(0).pose.at("q1_mm"), -6, 1e-9);
  EXPECT_NEAR(plan.truth(5).pose.at("q1_mm"), 6, 1e-9);
  const Plan sharp = scene.plan({ALLTACT_BARE, "motion-blur", "rolling-shutter"});
  const Plan rolled = scene.plan({ALLTACT_BARE, "motion-blur"});
  // Where the face ends in a row: the greatest fall of light.
  const auto end_px = [](const cv::Mat_<float>& light, int v) {
    int end = 700;
    for (int u = end; u < 950; ++u)
      if (light(v, u) - light(v, u + 1) > light(v, end) - light(v, end + 1)) end = u;
    return end;
  };
  const int frame = 3, middle = 270;
  const cv::Mat_<float> still = sharp.render(frame);
  const int end = end_px(still, middle);
  const auto width_px = [&](const Plan& which) {
    const cv::Mat_<float> light = which.render(frame);
    return step_width_px(
        {light.ptr<float>(middle) + end - 12, light.ptr<float>(middle) + end + 12});
  };
  EXPECT_GT(width_px(plan), width_px(sharp) + 1);
  // Rows above the middle are of an earlier moment, rows below of a later one.
  const cv::Mat_<float> now = rolled.render(frame);
  const int before = end_px(sharp.render(frame - 1), middle),
            after = end_px(sharp.render(frame + 1), middle);
  EXPECT_LT(after, before);
  const auto reach = [&](const cv::Mat_<float>& light, int v) {
    return cv::sum(light(cv::Rect(end - 15, v, 30, 1)))[0];
  };
  EXPECT_GT(reach(now, 240), reach(still, 240) + 2);
  EXPECT_LT(reach(now, 300), reach(still, 300) - 2);
}

TEST(ShippedScenes, HardJpeg) {
  const ShippedScene scene("hard_jpeg");
  const SentFrame sent = scene.plan().send(0), plain = scene.plan({"mjpeg"}).send(0);
  ASSERT_TRUE(sent.jpeg);
  EXPECT_FALSE(plain.jpeg);
  EXPECT_LT(sent.jpeg->size(), 25'000U);
  cv::Mat off;
  sent.grey.convertTo(off, CV_32F);
  cv::Mat exact;
  plain.grey.convertTo(exact, CV_32F);
  cv::Scalar mean, sd;
  cv::meanStdDev(off - exact, mean, sd);
  EXPECT_GT(sd[0], 0.5);
  EXPECT_LT(sd[0], 4);
}

TEST(ShippedScenes, HardLostFrames) {
  const Plan plan = ShippedScene("hard_lost_frames").plan();
  int lost = 0, late = 0, pairs = 0;
  bool before = false;
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Arrival arrival = plan.arrival(frame);
    lost += arrival.is_dropped;
    pairs += arrival.is_dropped && before;
    before = arrival.is_dropped;
    EXPECT_TRUE(arrival.late_ms == 0 || arrival.late_ms == 60);
    late += arrival.late_ms > 0;
  }
  EXPECT_GE(lost, 4);
  EXPECT_LE(lost, 24);
  EXPECT_GE(pairs, 2);
  EXPECT_GE(late, 4);
  EXPECT_LE(late, 24);
}

TEST(ShippedScenes, HardSmallPicture) {
  const Plan plan = ShippedScene("hard_small_picture").plan();
  EXPECT_EQ(plan.render(0).size(), cv::Size(320, 180));
  for (int frame = 0; frame < 3; ++frame)
    EXPECT_EQ(region_count(deeper_than(plan.truth(frame), 0.1)), 1);
}

TEST(ShippedScenes, HardWideLens) {
  const ShippedScene scene("hard_wide_lens");
  const Truth bent = scene.plan().truth(0), straight = scene.plan({"distortion"}).truth(0);
  double most = 0;
  for (std::size_t i = 0; i < bent.markers.size(); ++i)
    most = std::max(most, std::hypot(bent.markers[i].u - straight.markers[i].u,
                                     bent.markers[i].v - straight.markers[i].v));
  EXPECT_GT(most, 15);
  EXPECT_LT(most, 60);
}

TEST(ShippedScenes, HardBehindAWindow) {
  const ShippedScene scene("hard_behind_a_window");
  const Truth behind = scene.plan().truth(0), free = scene.plan({"port"}).truth(0);
  // Snell's law for the ray to each dot: from the lens 4 mm of air, 3 mm of acrylic (1.49), then
  // silicone (1.41). What is 12 mm or more off the axis there is seen farther in without a plate.
  const double f = 350, cu = 479.5, cv = 269.5;
  for (std::size_t i = 0; i < free.markers.size(); ++i) {
    const auto direction = [&](const Truth::Dot& dot) {
      return std::hypot((dot.u - cu) / f, (dot.v - cv) / f);
    };
    const double in_air = direction(behind.markers[i]), sine = std::sin(std::atan(in_air));
    const auto tan_in = [&](double index) { return std::tan(std::asin(sine / index)); };
    // Where the bent ray is off the axis at the depth z at which the straight one meets the dot.
    const double r_per_z = direction(free.markers[i]);
    const double z = (4 * in_air + 3 * tan_in(1.49) - 7 * tan_in(1.41)) / (r_per_z - tan_in(1.41));
    EXPECT_GT(z, 14) << i;  // the dots lie 14 mm and more before the camera, all of them ...
    EXPECT_LT(z, 110) << i;
    EXPECT_GT(in_air, r_per_z) << i;
  }
}

}  // namespace
}  // namespace alltact
