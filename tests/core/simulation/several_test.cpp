// Several effects of one kind in one frame.
#include "core/numerics/philox.h"
#include "core/simulation/noise.h"
#include "tests/core/simulation/scene_text.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

std::string ball(double radius_mm, double s_mm, double y_mm, double depth_mm) {
  return fmt::format("  - {{use: ball, radius_mm: {}, s_mm: {}, y_mm: {}, depth_mm: {}}}\n",
                     radius_mm, s_mm, y_mm, depth_mm);
}

const std::string kDrawnBall =
    "  - {use: ball, radius_mm: 4, s_mm: {from: 20, to: 90}, y_mm: {from: -5, to: 5},\n"
    "     depth_mm: {from: 0.3, to: 1.2}}\n";

std::string refusal_to_read(const std::string& yaml) {
  const auto scene = Scene::parse(yaml, "test.yaml");
  return scene ? "" : scene.error().sentence();
}

// Where two balls press, the deeper one counts; the picture follows from the depth.
TEST(Several, TwoBallsPressTheGreaterOfTheirDepths) {
  const std::string rest =
      "  - {use: rolloff, kind: hertz, length_mm: 0.5}\n"
      "  - {use: layer, scatter_per_mm: 0.6, along: z}\n";
  struct {
    double s, y;
  } const seconds[]{{70, -2}, {43, 1}, {40, 0.5}};  // apart, overlapping, nearly the same
  for (const auto& [s, y] : seconds) {
    const std::string one = ball(4, 40, 1, 0.8), other = ball(2.5, s, y, 1.1);
    const Plan both = plan_of(scene_text(one + other + rest));
    const Truth a = plan_of(scene_text(one + rest)).truth(0);
    const Truth b = plan_of(scene_text(other + rest)).truth(0);
    const Truth got = both.truth(0);
    const cv::Mat image = both.render(0, 2);
    int pressed = 0;
    for (int v = 0; v < got.depth_mm.rows; ++v)
      for (int u = 0; u < got.depth_mm.cols; ++u) {
        const float deeper = std::max(a.depth_mm.at<float>(v, u), b.depth_mm.at<float>(v, u));
        if (std::isnan(deeper)) continue;
        ASSERT_EQ(got.depth_mm.at<float>(v, u), deeper) << u << ' ' << v;
        pressed += deeper > 0.1F;
        const float thickness =
            got.untouched_z_mm.at<float>(v, u) - got.view_z_mm.at<float>(v, u) - deeper;
        const float light = 0.6F * thickness / (1 + 0.6F * thickness);
        if (u > 10 && u < 230 && v > 60 && v < 120) {
          ASSERT_NEAR(image.at<float>(v, u), light, 1e-5) << u << ' ' << v;
        }
      }
    EXPECT_GT(pressed, 100);
    ASSERT_EQ(got.balls.size(), 2U);
    EXPECT_EQ(got.balls[0].centre_mm, a.ball->centre_mm);
    EXPECT_EQ(got.balls[1].centre_mm, b.ball->centre_mm);
    EXPECT_EQ(got.ball->centre_mm, a.ball->centre_mm);
    const auto json = nlohmann::json::parse(got.to_json());
    EXPECT_EQ(json.at("balls").size(), 2U);
    EXPECT_EQ(json.at("ball"), json.at("balls").at(0));
    EXPECT_EQ(nlohmann::json::parse(a.to_json()).count("balls"), 0U);
  }
}

TEST(Several, TheFirstKeepsItsDrawsAndTheOthersHaveTheirOwn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Plan one = plan_of(scene_text(kDrawnBall), seed);
    const Plan three = plan_of(scene_text(kDrawnBall + kDrawnBall + kDrawnBall), seed);
    for (int frame = 0; frame < 3; ++frame) {
      const auto balls = three.truth(frame).balls;
      ASSERT_EQ(balls.size(), 3U);
      EXPECT_EQ(balls[0].centre_mm, one.truth(frame).ball->centre_mm);
      EXPECT_EQ(balls[0].depth_mm, one.truth(frame).ball->depth_mm);
      for (const auto& [a, b] : {std::pair{0U, 1U}, {0U, 2U}, {1U, 2U}})
        EXPECT_GT((balls[a].centre_mm - balls[b].centre_mm).norm(), 1e-6);
    }
  }
}

// The second read noise after a hand-over: none of the first one's numbers, and as normal.
TEST(Several, NoiseThatIsHandedOverDrawsAnew) {
  const Plan plan =
      plan_of(scene_text("  - {use: read, sd: 1, until: 1}\n  - {use: read, sd: 1, from: 1}\n"));
  const std::uint64_t seed = 7 ^ std::uint64_t{fnv1a("test")} << 32;
  std::vector<float> draws(320);
  const cv::Mat first = plan.render(0), second = plan.render(1);
  double product = 0, square = 0;
  for (int v = 0; v < 10; ++v) {
    for (int frame = 0; frame < 2; ++frame) {
      RowNoise("read").normals(seed, frame, v, 320, draws.data());
      const cv::Mat& image = frame == 0 ? first : second;
      for (int u = 0; u < 320; ++u) {
        const float drawn = draws[static_cast<std::size_t>(u)], got = image.at<float>(v, u);
        if (frame == 0) {
          ASSERT_EQ(got, drawn);
        } else {
          product += double{got} * drawn;
          square += double{got} * got;
        }
      }
    }
  }
  EXPECT_LT(std::abs(product / 3200), 4 / std::sqrt(3200.0));
  EXPECT_NEAR(square / 3200, 1, 4 * std::sqrt(2 / 3200.0));
}

TEST(Several, FramesAreLostToEitherOfTwoCauses) {
  std::string text = scene_text("  - {use: drop, share: 0.3}\n  - {use: drop, share: 0.2}\n");
  text.replace(text.find("frames: 3"), 9, "frames: 4000");
  const Plan plan = plan_of(text);
  int dropped = 0;
  for (int frame = 0; frame < 4000; ++frame) dropped += plan.arrival(frame).is_dropped;
  const double expected = 1 - 0.7 * 0.8;
  EXPECT_NEAR(dropped / 4000.0, expected, 4 * std::sqrt(expected * (1 - expected) / 4000));
}

TEST(Several, GiveTheSameBytesWithAnyThreads) {
  const std::string rest =
      "  - {use: rolloff, kind: smooth, length_mm: 0.2}\n"
      "  - {use: bulge, share: 0.03, width_mm: 1.5}\n"
      "  - {use: sides, albedo: 0.1, depth_mm: 9}\n"
      "  - {use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1}\n"
      "  - {use: occlusion, count: 2}\n  - {use: occlusion, markers: [3]}\n"
      "  - {use: relief, shape: t_bar, size_mm: 9, bar_mm: 2, s_mm: 80, y_mm: 0, depth_mm: 0.5}\n";
  for (const std::uint64_t seed : {1, 5}) {
    const Plan plan = plan_of(scene_text(kDrawnBall + kDrawnBall + rest), seed);
    const cv::Mat image = plan.render(2);
    for (const int threads : {2, 3, 7}) EXPECT_TRUE(same_bytes(plan.render(2, threads), image));
    EXPECT_FALSE(plan.truth(2).markers[3].visible);
  }
}

TEST(Several, EachHasItsOwnNameInErrors) {
  EXPECT_THAT(refusal_to_read(scene_text(ball(4, 30, 0, 1) + ball(-1, 60, 0, 1))),
              HasSubstr("test.yaml:11: ball#2.radius_mm: must be"));
  const auto scene = Scene::parse(scene_text(ball(4, 30, 0, 1) + ball(4, 600, 0, 1)), "test.yaml");
  ASSERT_TRUE(scene);
  EXPECT_THAT(Plan::compile(*scene, 1).error().sentence(), HasSubstr("test.yaml:11: ball#2: s_mm"));
}

TEST(Several, TwoOfWhatThereCanBeOneOfAreRefused) {
  for (const char* effect :
       {"bend, q1_mm: {from: -1, to: 1}, q2_mm: {from: -1, to: 1}",
        "sway, sway_mm: {from: -1, to: 1}", "layer, scatter_per_mm: 0.6, along: z",
        "sides, albedo: 0.1, depth_mm: 9", "leds, lamps: [{at_mm: [0, 3, 0], power: 500000}]",
        "shot, gain: 0.1", "quantisation", "mjpeg, quality: 80"}) {
    const std::string line = fmt::format("  - {{use: {}}}\n", effect);
    EXPECT_THAT(refusal_to_read(scene_text(line + line)), HasSubstr("test.yaml:11: ")) << effect;
    EXPECT_THAT(refusal_to_read(scene_text(line + line)), HasSubstr("#2.use: the effect"))
        << effect;
    EXPECT_THAT(refusal_to_read(scene_text(line + line)), HasSubstr("is listed twice. Try:"))
        << effect;
    const std::string early = fmt::format("  - {{use: {}, until: 1}}\n", effect);
    const std::string late = fmt::format("  - {{use: {}, from: 1}}\n", effect);
    EXPECT_EQ(refusal_to_read(scene_text(early + late)), "") << effect;
  }
}

}  // namespace
}  // namespace alltact
