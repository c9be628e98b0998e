#include "core/simulation/plan.h"

#include "core/numerics/philox.h"
#include "core/simulation/noise.h"
#include "tests/core/simulation/scene_text.h"

#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;

const std::string kLight =
    "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
    "  - {use: leds, lamps: [{at_mm: [0, 3, 0], power: 500000}]}\n";
const std::string kEverything =
    "  - {use: bend, q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}}\n"
    "  - {use: sway, sway_mm: {from: -2, to: 2}}\n"
    "  - {use: ball, radius_mm: 4, s_mm: {from: 20, to: 60}, y_mm: 2, depth_mm: 1}\n"
    "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n"
    "  - {use: bulge, share: 0.03, width_mm: 1.5}\n"
    "  - {use: markers, radius_mm: 1.5, setback_mm: 4, first: 0.1, last: 0.9, albedo: 0.9}\n"
    "  - {use: occlusion, count: 3}\n"
    "  - {use: sides, albedo: 0.1, depth_mm: 14}\n" +
    kLight +
    "  - {use: shot, gain: 0.03}\n"
    "  - {use: read, sd: 1}\n";

TEST(Plan, HoldsWhatIsNamedAndNothingElse) {
  EXPECT_THAT(plan_of(scene_text("")).effects(), ElementsAre());
  // In physical order, whatever the scene's.
  EXPECT_THAT(
      plan_of(scene_text("  - {use: quantisation}\n  - {use: read, sd: 1}\n" + kLight)).effects(),
      ElementsAre("layer", "leds", "read", "quantisation"));
}

TEST(Plan, GivesTheSameBytesWithAnyThreadsAndInAnyOrder) {
  const std::string text = "motion: {kind: wander, frames_per_move: 4}\n" +
                           scene_text(kEverything + "  - {use: quantisation}\n");
  const Plan plan = plan_of(text), again = plan_of(text);
  std::vector<cv::Mat> first;
  for (int i = 0; i < 3; ++i) first.push_back(plan.render(i));
  for (const int i : {2, 0, 1})
    for (const int threads : {1, 2, 3, 7})
      EXPECT_TRUE(same_bytes(again.render(i, threads), first[static_cast<std::size_t>(i)]));
  EXPECT_FALSE(same_bytes(first[0], first[1]));
  EXPECT_FALSE(same_bytes(plan_of(text, 8).render(0), first[0]));
}

// One more effect changes no draw of the others. Where the picture is black, a pixel with read
// noise of 1 is the draw itself, and shot noise adds nothing.
TEST(Plan, NamingAnotherEffectDisturbsNoDraw) {
  const std::string read = "  - {use: read, sd: 1}\n", shot = "  - {use: shot, gain: 0.5}\n";
  const std::string dots =
      "  - {use: occlusion, count: 3}\n  - {use: sides, albedo: 0.1, depth_mm: 9}\n"
      "  - {use: markers, radius_mm: 1, setback_mm: 4, first: 0.2, last: 1, albedo: 1}\n";
  const RowNoise noise("read");
  std::vector<float> draws(320);
  for (const std::string& others : {std::string(), shot, dots, dots + shot})
    for (const bool before : {true, false}) {
      const cv::Mat clean = plan_of(scene_text(dots)).render(1);
      const cv::Mat noisy =
          plan_of(scene_text(before ? others + read : read + others)).render(1, before ? 1 : 4);
      int compared = 0;
      for (int v = 0; v < clean.rows; ++v) {
        noise.normals(7 ^ std::uint64_t{fnv1a("test")} << 32, 1, v, clean.cols, draws.data());
        for (int u = 0; u < clean.cols; ++u) {
          if (clean.at<float>(v, u) != 0.0F) continue;
          ASSERT_EQ(noisy.at<float>(v, u), draws[static_cast<std::size_t>(u)]) << u << ' ' << v;
          ++compared;
        }
      }
      EXPECT_GT(compared, 1000);
    }
}

TEST(RowNoise, IsPhiloxAndStandardNormal) {
  const RowNoise a("read");
  std::vector<float> wide(4099), narrow(100);
  a.normals(0x123456789ULL, 5, 11, 4099, wide.data());
  a.normals(0x123456789ULL, 5, 11, 100, narrow.data());
  for (std::size_t i = 0; i < narrow.size(); ++i) EXPECT_EQ(wide[i], narrow[i]);
  // The batched generator against the plain one: quantiles grow with their 16 bits.
  for (std::size_t i = 0; i + 1 < 4096; ++i) {
    const auto index = [](std::size_t x) {
      const auto bits =
          philox({static_cast<std::uint32_t>(x / 8), 11, 5, 1}, {0x23456789U, fnv1a("read")});
      return bits[x % 8 / 2] >> (x % 2 == 0 ? 0 : 16) & 0xFFFFU;
    };
    EXPECT_EQ(index(i) < index(i + 1), wide[i] < wide[i + 1]);
  }
  double sum = 0, sum2 = 0, sum4 = 0;
  const int rows = 2000, n = 512;
  std::vector<float> x(n);
  for (int row = 0; row < rows; ++row) {
    a.normals(3, 0, row, n, x.data());
    for (const float value : x) {
      sum += value;
      sum2 += double{value} * value;
      sum4 += std::pow(double{value}, 4);
    }
  }
  const double total = double{rows} * n;
  EXPECT_NEAR(sum / total, 0, 4 / std::sqrt(total));
  EXPECT_NEAR(sum2 / total, 1, 4 * std::sqrt(2 / total));
  EXPECT_NEAR(sum4 / total, 3, 4 * std::sqrt(96 / total));
}

TEST(Plan, ScenesOfOtherNamesShareNoNoise) {
  std::string other = scene_text("  - {use: read, sd: 1}\n");
  const cv::Mat a = plan_of(other).render(0);
  const cv::Mat b = plan_of(other.replace(0, 10, "name: tent")).render(0);
  const cv::Rect corner(0, 0, 320, 5);
  EXPECT_LT(std::abs(a(corner).dot(b(corner)) / 1600), 4 / std::sqrt(1600.0));
}

// Kubelka-Munk over black and inverse squares, in long double, for a face that is not bent.
TEST(Plan, WithoutNoiseEqualsTheFormula) {
  for (const long double absorb : {0.0L, 0.03L}) {
    std::string text = "  - {use: layer, scatter_per_mm: 0.6, along: z";
    if (absorb > 0) text += ", absorb_per_mm: 0.03";
    text +=
        "}\n  - {use: leds, lamps: [{at_mm: [1, -3, -2], power: 500000}, "
        "{at_mm: [4, 5, 0], power: 2000000, aim_mm: [71, 0, 93], lobe: 4}]}\n";
    const cv::Mat image = plan_of(scene_text(text)).render(0);
    const long double theta = 34.0L * std::numbers::pi_v<long double> / 180;
    const long double thickness = 1.5L / std::cos(theta), scatter = 0.6L;
    long double reflectance = scatter * thickness / (1 + scatter * thickness);
    if (absorb > 0) {
      const long double a = (scatter + absorb) / scatter, b = std::sqrt(a * a - 1);
      const long double x = b * scatter * thickness;
      reflectance = std::sinh(x) / (a * std::sinh(x) + b * std::cosh(x));
    }
    using Vector = Eigen::Matrix<long double, 3, 1>;
    const Vector normal(std::sin(theta), 0, -std::cos(theta));
    int compared = 0;
    for (int v = 0; v < image.rows; v += 3)
      for (int u = 0; u < image.cols; u += 3) {
        const long double t = (u - 158.5L) / 170, w = (v - 90.25L) / 172;
        const long double z =
            (28 * std::cos(theta) + 25 * std::sin(theta)) / (std::cos(theta) - t * std::sin(theta));
        const Vector p(t * z, w * z, z);
        const long double s = (p.x() + 25) / std::cos(theta);
        if (std::abs(p.y()) > 12 - z / 172 || s < 2 || s > 114) continue;
        const Vector one(1, -3, -2), two(4, 5, 0), aim = Vector(67, -5, 93).normalized();
        const auto shine = [&](const Vector& lamp) {
          const Vector way = lamp - p;
          return normal.dot(way) / std::pow(way.norm(), 3);
        };
        const long double lobe = std::pow(aim.dot((p - two).normalized()), 4);
        const long double expected =
            reflectance * (500000 * shine(one) + 2000000 * lobe * shine(two));
        EXPECT_NEAR(image.at<float>(v, u) / static_cast<double>(expected), 1, 1e-6);
        ++compared;
      }
    EXPECT_GT(compared, 1000);
  }
}

TEST(Plan, NoiseHasTheRightMeanAndVariance) {
  const std::string clean_text = scene_text(kLight);
  std::string noisy_text =
      scene_text(kLight + "  - {use: shot, gain: 0.03}\n  - {use: read, sd: 1}\n");
  noisy_text.replace(noisy_text.find("frames: 3"), 9, "frames: 400");
  const cv::Mat clean = plan_of(clean_text).render(0);
  const Plan plan = plan_of(noisy_text);
  cv::Mat_<double> sum = cv::Mat_<double>::zeros(clean.size()), sum2 = sum.clone();
  for (int i = 0; i < 400; ++i) {
    cv::Mat_<double> difference;
    cv::subtract(plan.render(i), clean, difference, cv::noArray(), CV_64F);
    sum += difference;
    sum2 += difference.mul(difference);
  }
  // 57600 means: about 4 of them would lie beyond 4 sigma by chance, none beyond 6.
  int beyond_4 = 0;
  double ratio = 0;
  for (int v = 0; v < clean.rows; ++v)
    for (int u = 0; u < clean.cols; ++u) {
      const double variance = 1 + 0.03 * clean.at<float>(v, u);
      const double off = std::abs(sum(v, u) / 400) / std::sqrt(variance / 400);
      beyond_4 += off > 4;
      ASSERT_LT(off, 6);
      ratio += sum2(v, u) / 400 / variance;
    }
  EXPECT_LT(beyond_4, 15);
  EXPECT_NEAR(ratio / static_cast<double>(clean.total()), 1, 0.005);
  // The law, grey level by grey level.
  for (const int level : {0, 40, 80, 120}) {
    double got = 0, expected = 0;
    for (int v = 0; v < clean.rows; ++v)
      for (int u = 0; u < clean.cols; ++u)
        if (const float grey = clean.at<float>(v, u); grey >= level && grey < level + 40) {
          got += sum2(v, u) / 400;
          expected += 1 + 0.03 * grey;
        }
    ASSERT_GT(expected, 0);
    EXPECT_NEAR(got / expected, 1, 0.05) << level;
  }
}

TEST(Plan, QuantisationRoundsAndClips) {
  const cv::Mat levels = plan_of(scene_text(kLight)).render(0);
  const cv::Mat bytes = plan_of(scene_text(kLight + "  - {use: quantisation}\n")).render(0);
  ASSERT_EQ(bytes.type(), CV_8UC1);
  for (int v = 0; v < bytes.rows; ++v)
    for (int u = 0; u < bytes.cols; ++u) {
      const float clipped = std::clamp(levels.at<float>(v, u), 0.0F, 255.0F);
      EXPECT_LE(std::abs(clipped - bytes.at<std::uint8_t>(v, u)), 0.5F + 1e-4F);
    }
}

TEST(Plan, OcclusionHidesAsManyAsItSays) {
  const Plan plan = plan_of("motion: {kind: random}\n" + scene_text(kEverything));
  std::set<std::vector<bool>> patterns;
  for (int i = 0; i < 20; ++i) {
    std::vector<bool> visible;
    for (const auto& dot : plan.truth(i).markers) visible.push_back(dot.visible);
    ASSERT_EQ(visible.size(), 12U);
    EXPECT_EQ(std::count(visible.begin(), visible.end(), false), 3);
    patterns.insert(visible);
  }
  EXPECT_GT(patterns.size(), 10U);
}

}  // namespace
}  // namespace alltact
