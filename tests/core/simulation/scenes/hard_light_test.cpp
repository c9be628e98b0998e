// The hard cases of light, skin and body show what they say.
#include "tests/core/simulation/scenes/shipped_scene.h"

namespace alltact {
namespace {

TEST(ShippedScenes, HardDeadLamp) {
  const ShippedScene scene("hard_dead_lamp");
  const Plan plan = scene.plan({ALLTACT_BARE}), all_lit = scene.plan({ALLTACT_BARE, "dead-lamp"});
  // Without the lamp's line instead of without its light.
  std::string text = scene.text({ALLTACT_BARE, "dead-lamp"});
  const std::size_t line = text.find("      - {at_mm: [4.0, 0.0, -20.0]");
  text.erase(line, text.find('\n', line) + 1 - line);
  const Plan two_lamps = scene.plan_of_text(text);
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Plan& same = frame < 4 ? all_lit : two_lamps;
    EXPECT_LT(cv::norm(plan.render(frame), same.render(frame), cv::NORM_INF), 1e-3) << frame;
    EXPECT_EQ(cv::countNonZero(deeper_than(plan.truth(frame), 0)) > 0, frame >= 6);
  }
  EXPECT_GT(cv::norm(all_lit.render(5), two_lamps.render(5), cv::NORM_INF), 50);
}

TEST(ShippedScenes, HardDriftingLamps) {
  const ShippedScene scene("hard_drifting_lamps");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const cv::Mat_<float> steady = scene.plan({ALLTACT_BARE, "warming", "gain-drift"}).render(0);
  const cv::Mat face = on_face(plan.truth(0));
  double wanders = 0, last = 0;
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    cv::Scalar share, uneven;
    cv::meanStdDev(ratio_of(plan.render(frame), steady), share, uneven, face);
    EXPECT_LT(uneven[0], 1e-4);
    const double warm = 1 - 0.1 * (1 - std::exp(-frame * 10 / 40.0));
    last = share[0] / warm - 1;
    EXPECT_LT(std::abs(last), 0.08) << frame;
    wanders = std::max(wanders, std::abs(last));
  }
  EXPECT_GT(wanders, 0.005);
}

TEST(ShippedScenes, HardFlickeringLamps) {
  const ShippedScene scene("hard_flickering_lamps");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const cv::Mat_<float> steady = scene.plan({ALLTACT_BARE, "flicker"}).render(0);
  const double x = std::numbers::pi * 100 * 0.008;
  double least = 2, most = 0;
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const double share =
        1 + 0.3 * std::sin(x) / x * std::cos(2 * std::numbers::pi * 100 * frame / 30.0);
    const cv::Mat_<float> light = plan.render(frame);
    EXPECT_NEAR(light(270, 400) / steady(270, 400), share, 1e-5) << frame;
    least = std::min(least, share);
    most = std::max(most, share);
  }
  EXPECT_GT(most / least, 1.08);
}

TEST(ShippedScenes, HardDimLamps) {
  const ShippedScene scene("hard_dim_lamps");
  const Plan plan = scene.plan({ALLTACT_BARE, "ball"});
  double least = 0, most = 0;
  cv::minMaxLoc(plan.render(0), &least, &most, nullptr, nullptr, within_face(plan.truth(0), 3));
  EXPECT_GE(least, 11);
  EXPECT_LE(most, 50);
}

TEST(ShippedScenes, HardAbsorbingBody) {
  const ShippedScene scene("hard_absorbing_body");
  const Plan plan = scene.plan({ALLTACT_BARE}), clear = scene.plan({ALLTACT_BARE, "absorption"});
  const Plan untouched = scene.plan({ALLTACT_BARE, "ball"});
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const Truth truth = plan.truth(frame);
    const cv::Mat_<float> share = ratio_of(plan.render(frame), clear.render(frame));
    // To the face and back: from 28 mm at the base to 93 mm at the tip, and the lamp 20 mm behind.
    EXPECT_LT(share(270, 850), 0.8 * share(270, 30));
    EXPECT_GT(share(270, 850), std::exp(-0.004 * (2 * 120 + 20)));
    // The layer's own absorption: at the deepest point by Kubelka and Munk.
    const cv::Point at = deepest_pixel(truth);
    const double cos = std::cos(34 * std::numbers::pi / 180);
    const double left = 1.5 - truth.depth_mm.at<float>(at) * cos;
    EXPECT_NEAR(plan.render(frame).at<float>(at) / untouched.render(frame).at<float>(at),
                layer_reflectance(0.6, 0.06, left) / layer_reflectance(0.6, 0.06, 1.5), 1e-4);
  }
}

TEST(ShippedScenes, HardScattering) {
  const ShippedScene scene("hard_scattering");
  const Plan plan = scene.plan({ALLTACT_BARE}), untouched = scene.plan({ALLTACT_BARE, "ball"});
  const cv::Mat_<float> bright = untouched.render(0);
  // Local light shows no contact where the skin is not pressed in.
  const Truth truth = plan.truth(0);
  const cv::Mat_<float> share = ratio_of(plan.render(0), bright);
  const cv::Point at = deepest_pixel(truth);
  int rim = at.y;
  while (truth.depth_mm.at<float>(rim, at.x) > 0) ++rim;
  const double px_per_mm = 523.9 / truth.view_z_mm.at<float>(at);
  const int near = rim + static_cast<int>(0.5 * px_per_mm);
  EXPECT_EQ(truth.depth_mm.at<float>(near, at.x), 0.0F);
  EXPECT_LT(share(near, at.x), 0.985);
  EXPECT_GT(share(near, at.x), 0.85);
  EXPECT_LT(share(at), 0.8);
}

TEST(ShippedScenes, HardInterreflection) {
  const ShippedScene scene("hard_interreflection");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const cv::Mat_<float> gain =
      ratio_of(plan.render(0), scene.plan({ALLTACT_BARE, "interreflection"}).render(0));
  const Truth truth = plan.truth(0);
  double least = 0, most = 0;
  cv::minMaxLoc(gain, &least, &most, nullptr, nullptr, within_face(truth, 2));
  EXPECT_GT(least, 1.003);
  EXPECT_LT(most, 1.5);
  // More beside the sides than in the middle.
  for (const int u : {150, 300, 450, 600}) {
    int top = 0;
    while (truth.depth_mm.at<float>(top, u) != truth.depth_mm.at<float>(top, u)) ++top;
    EXPECT_GT(gain(top + 3, u) - 1, 1.25 * (gain(270, u) - 1)) << u;
  }
}

TEST(ShippedScenes, HardVeilAndGlare) {
  const ShippedScene scene("hard_veil_and_glare");
  const Plan plan = scene.plan({ALLTACT_BARE}), no_veil = scene.plan({ALLTACT_BARE, "veil"});
  const Plan neither = scene.plan({ALLTACT_BARE, "veil", "glare"});
  for (int frame = 0; frame < plan.frame_count(); ++frame) {
    const cv::Mat_<float> light = plan.render(frame), clear = no_veil.render(frame);
    EXPECT_EQ(clear(270, 955), 0);  // beside the finger
    EXPECT_NEAR(light(270, 955), 0.05 * mean_of(clear), 1e-3);
    EXPECT_GT(light(270, 955), 2);
    double mirrored = 0;
    cv::minMaxLoc(clear - neither.render(frame), nullptr, &mirrored);
    EXPECT_NEAR(mirrored, 60, 3);
  }
}

TEST(ShippedScenes, HardLightLeak) {
  const ShippedScene scene("hard_light_leak");
  const Plan plan = scene.plan({ALLTACT_BARE}), closed = scene.plan({ALLTACT_BARE, "leak"});
  for (int frame = 0; frame < 4; ++frame) {
    double least = 0, most = 0;
    cv::minMaxLoc(plan.render(frame) - closed.render(frame), &least, &most);
    EXPECT_NEAR(least, frame < 2 ? 6 : 24, 1e-4);
    EXPECT_NEAR(most, frame < 2 ? 6 : 24, 1e-4);
  }
}

TEST(ShippedScenes, HardVignetting) {
  const ShippedScene scene("hard_vignetting");
  const cv::Mat_<float> share = ratio_of(scene.plan({ALLTACT_BARE}).render(0),
                                         scene.plan({ALLTACT_BARE, "vignetting"}).render(0));
  for (const int u : {20, 200, 480, 700, 860}) {
    const double tan = std::hypot((u - 479.5) / 523.9, (290 - 269.5) / 523.9);
    EXPECT_NEAR(share(290, u), std::pow(1 + tan * tan, -2), 1e-4) << u;
  }
}

TEST(ShippedScenes, HardDirtySkin) {
  const ShippedScene scene("hard_dirty_skin");
  const Plan plan = scene.plan({ALLTACT_BARE});
  const Plan clean = scene.plan({ALLTACT_BARE, "speck", "scratch", "bubble", "hole"});
  const Truth untouched = plan.truth(0);
  EXPECT_EQ(cv::countNonZero(deeper_than(untouched, 0)), 0);
  const cv::Mat_<float> share = ratio_of(plan.render(0), clean.render(0));
  const cv::Mat face = within_face(untouched, 2);
  EXPECT_GE(region_count((share < 0.93) & face), 7);  // specks, a bubble and a scratch
  EXPECT_GE(region_count((share > 1.07) & face), 2);  // a hole and a scratch
  for (int frame = 1; frame < 4; ++frame)
    EXPECT_EQ(region_count(deeper_than(plan.truth(frame), 0.05)), 1);
}

TEST(ShippedScenes, HardUnevenLayer) {
  const ShippedScene scene("hard_uneven_layer");
  const Plan plan = scene.plan({ALLTACT_BARE, "ball"});
  cv::Scalar mean, sd;
  cv::meanStdDev(
      ratio_of(plan.render(0), scene.plan({ALLTACT_BARE, "ball", "uneven-layer"}).render(0)), mean,
      sd, within_face(plan.truth(0), 2));
  // d ln R / d ln t = 1 / (1 + S t) of a thickness that varies by 0.05.
  EXPECT_NEAR(sd[0], 0.05 / (1 + 0.6 * 1.5), 0.009);
  EXPECT_NEAR(mean[0], 1, 0.02);
}

}  // namespace
}  // namespace alltact
