// Against surfaces whose measures are known in closed form, over many draws of the noise.
#include "core/sensing/surface_measurement.h"

#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kStepMm = 0.1, kFaceZMm = 60;

/// A patch of a face z = 60 mm, 61 x 61 pixels of a tenth of a millimetre, into which `depth_mm` is
/// pressed. Noise is independent from pixel to pixel.
SurfacePatch pressed(const std::function<double(double, double)>& depth_mm, double noise_mm,
                     unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SurfacePatch patch;
  for (int v = -30; v <= 30; ++v)
    for (int u = -30; u <= 30; ++u) {
      const double x = kStepMm * u, y = kStepMm * v;
      SurfacePoint point;
      point.untouched_mm = {x, y, kFaceZMm};
      point.depth_mm = depth_mm(x, y) + noise_mm * normal(random);
      point.noise_mm = noise_mm;
      point.on_face_mm2 = point.projected_mm2 = kStepMm * kStepMm;
      patch.points.push_back(point);
    }
  return patch;
}

/// How deep a ball of this radius, its deepest point at `deepest_mm`, presses.
double cap_depth(double x, double y, double radius_mm, double deepest_mm) {
  const double squared = radius_mm * radius_mm - x * x - y * y;
  return squared > 0 ? std::max(0.0, deepest_mm - radius_mm + std::sqrt(squared)) : 0;
}

TEST(SurfacePatchTest, ABallHasItsRadiusToTheLastDigitsWithoutNoise) {
  for (const double radius : {1.5, 3.0, 8.0, 20.0}) {
    const auto patch =
        pressed([&](double x, double y) { return cap_depth(x, y, radius, 0.2); }, 0, 1);
    const auto ball = fit_ball(patch);
    ASSERT_TRUE(ball) << ball.error().message().english();
    EXPECT_NEAR(ball->radius_mm.value, radius, 1e-9 * radius);
    // The skin bulges towards the camera: the ball lies behind it.
    EXPECT_NEAR(ball->centre_mm.z(), kFaceZMm - 0.2 + radius, 1e-9 * radius);
    EXPECT_LT(ball->residual_mm, 1e-10);
  }
}

TEST(SurfacePatchTest, ABallsRadiusIsAsSureAsItSays) {
  double squares = 0;
  constexpr int kRuns = 200;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const auto patch =
        pressed([](double x, double y) { return cap_depth(x, y, 3, 0.4); }, 0.01, seed);
    const auto ball = fit_ball(patch);
    ASSERT_TRUE(ball);
    squares += std::pow((ball->radius_mm.value - 3) / ball->radius_mm.sd, 2);
  }
  EXPECT_NEAR(squares / kRuns, 1, 0.3);
}

TEST(SurfacePatchTest, WhatIsCommonToDepthsMovesTheRadiusByAsMuch) {
  // Depths that are told 1 % too great stretch the cap: curvature grows by 1 %, the radius shrinks.
  auto patch = pressed([](double x, double y) { return cap_depth(x, y, 5, 0.2); }, 1e-5, 3);
  for (auto& point : patch.points) point.common_mm = 0.01 * point.depth_mm;
  const auto ball = fit_ball(patch);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->radius_mm.sd, 0.05, 0.005);
}

TEST(SurfacePatchTest, APlaneIsNoBall) {
  const auto flat = pressed([](double, double) { return 0.3; }, 0.002, 4);
  const auto ball = fit_ball(flat);
  EXPECT_FALSE(ball);
  SurfacePatch few = flat;
  few.points.resize(20);
  EXPECT_FALSE(fit_ball(few));
  EXPECT_FALSE(fit_ball(SurfacePatch{}));
}

TEST(SurfacePatchTest, VolumeAndAreaOfACapAreThoseOfGeometry) {
  constexpr double kRadius = 3, kDeep = 0.5;
  const auto patch =
      pressed([](double x, double y) { return cap_depth(x, y, kRadius, kDeep); }, 0, 5);
  const auto part = pressed_part(patch, 1e-9);
  ASSERT_TRUE(part);
  const double volume = std::numbers::pi * kDeep * kDeep * (3 * kRadius - kDeep) / 3;
  const double area = std::numbers::pi * (2 * kRadius * kDeep - kDeep * kDeep);
  EXPECT_NEAR(part->volume_mm3.value, volume, 0.002 * volume);
  EXPECT_NEAR(part->area_mm2.value, area, 0.01 * area);
  EXPECT_NEAR(part->mean_mm.value, volume / area, 0.01 * volume / area);
  EXPECT_FALSE(pressed_part(patch, 0.6));
}

TEST(SurfacePatchTest, AVolumeIsAsSureAsItSays) {
  double squares = 0;
  constexpr int kRuns = 200;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    std::mt19937 random(seed + 1000);
    const double common = 0.003 * std::normal_distribution<double>()(random);
    auto patch = pressed([&](double, double) { return 0.3 + common; }, 0.01, seed);
    for (auto& point : patch.points) point.common_mm = 0.003;
    const auto part = pressed_part(patch, 0.1);
    ASSERT_TRUE(part);
    squares += std::pow((part->volume_mm3.value - 0.3 * 6.1 * 6.1) / part->volume_mm3.sd, 2);
  }
  EXPECT_NEAR(squares / kRuns, 1, 0.3);
}

TEST(SurfacePatchTest, RoughnessOfASineIsItsAmplitudeOverRootTwoWhateverItsForm) {
  constexpr double kAmplitude = 0.02;
  const auto wave = [](double x, double y) {
    return 0.5 + 0.1 * x - 0.05 * y + 0.03 * x * x - 0.02 * x * y +
           kAmplitude * std::sin(2 * std::numbers::pi * x / 0.6);
  };
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto rough = roughness(pressed(wave, 0.01, seed));
    ASSERT_TRUE(rough);
    EXPECT_NEAR(rough->sq_mm.value, kAmplitude / std::numbers::sqrt2, 5 * rough->sq_mm.sd + 2e-4);
    EXPECT_LT(rough->sq_mm.sd, 0.001);
  }
}

TEST(SurfacePatchTest, SmoothSkinIsNotCalledRough) {
  int called_rough = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto rough =
        roughness(pressed([](double x, double) { return 0.3 + 0.1 * x; }, 0.01, seed));
    ASSERT_TRUE(rough);
    EXPECT_NEAR(rough->noise_mm, 0.01, 0.001);
    called_rough += rough->sq_mm.value > 2 * rough->sq_mm.sd;
  }
  EXPECT_LE(called_rough, 12);
}

TEST(SurfacePatchTest, AFormOfEachDegreeIsRemovedAndNoLowerOne) {
  constexpr double kAmplitude = 0.02;
  for (int degree = 1; degree <= kMaxFormDegree; ++degree) {
    const auto wave = [degree](double x, double y) {
      const double form = 0.3 * std::pow((x - 0.5 * y) / 3, degree);
      return 1 + form + kAmplitude * std::sin(2 * std::numbers::pi * x / 0.6);
    };
    const auto patch = pressed(wave, 0, 1);
    const auto rough = roughness(patch, {.form_degree = degree, .lambda_c_mm = {}});
    ASSERT_TRUE(rough) << degree;
    EXPECT_NEAR(rough->sq_mm.value, kAmplitude / std::numbers::sqrt2, 3e-4) << degree;
    if (degree == 1) continue;
    const auto rougher = roughness(patch, {.form_degree = degree - 1, .lambda_c_mm = {}});
    ASSERT_TRUE(rougher);
    EXPECT_GT(rougher->sq_mm.value, 1.2 * rough->sq_mm.value) << degree;
  }
}

TEST(SurfacePatchTest, WavesPassTheGaussianFilterAsTheStandardSays) {
  constexpr double kAmplitude = 0.02, kLambda_mm = 0.8;
  for (const double wave_mm : {0.4, 0.6, 0.8, 1.2, 1.6}) {
    const auto wave = [wave_mm](double x, double y) {
      return 0.5 + kAmplitude * std::sin(2 * std::numbers::pi * (0.8 * x + 0.6 * y) / wave_mm);
    };
    const auto rough =
        roughness(pressed(wave, 0, 1), {.form_degree = 1, .lambda_c_mm = kLambda_mm});
    ASSERT_TRUE(rough);
    // ISO 16610-61: the filter's mean line transmits 2^-(lambda_c / lambda)^2 of a wave.
    const double passes = 1 - std::exp2(-std::pow(kLambda_mm / wave_mm, 2));
    EXPECT_NEAR(rough->sq_mm.value, passes * kAmplitude / std::numbers::sqrt2,
                0.03 * kAmplitude / std::numbers::sqrt2)
        << wave_mm;
  }
}

TEST(SurfacePatchTest, SmoothSkinIsNotCalledRoughBehindAFilterEither) {
  int called_rough = 0;
  double sum = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto rough =
        roughness(pressed([](double x, double) { return 0.3 + 0.1 * x; }, 0.01, seed),
                  {.form_degree = 4, .lambda_c_mm = 0.8});
    ASSERT_TRUE(rough);
    EXPECT_NEAR(rough->noise_mm, 0.01, 0.001);
    sum += rough->sq_mm.value;
    called_rough += rough->sq_mm.value > 2 * rough->sq_mm.sd;
  }
  EXPECT_LE(called_rough, 12);
  EXPECT_LT(sum / 100, 0.0015);
}

TEST(SurfacePatchTest, AFilterThatThePatchCannotHoldIsRefused) {
  const auto patch = pressed([](double, double) { return 0.3; }, 0.01, 1);
  EXPECT_FALSE(roughness(patch, {.form_degree = 2, .lambda_c_mm = 0.4}));  // four pixels
  EXPECT_TRUE(roughness(patch, {.form_degree = 2, .lambda_c_mm = 0.6}));
  EXPECT_FALSE(roughness(patch, {.form_degree = 2, .lambda_c_mm = 7.0}));
}

TEST(SurfacePatchTest, AnglesBetweenPlanesAreThoseTheyWereMadeWith) {
  for (const double slope : {0.0, 0.1, 0.5, 1.0}) {
    const auto a = fit_plane(pressed([](double, double) { return 0.5; }, 1e-4, 6));
    const auto b = fit_plane(pressed([&](double x, double) { return 0.5 + slope * x; }, 1e-4, 7));
    ASSERT_TRUE(a && b);
    const MeasuredValue angle = angle_deg(*a, *b);
    EXPECT_NEAR(angle.value, std::atan(slope) * 180 / std::numbers::pi, 0.01) << slope;
    EXPECT_LT(angle.sd, 0.01);
  }
}

TEST(SurfacePatchTest, AnAngleIsAsSureAsItSays) {
  double squares = 0;
  constexpr int kRuns = 200;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const auto a = fit_plane(pressed([](double, double) { return 0.5; }, 0.02, 2 * seed));
    const auto b =
        fit_plane(pressed([](double x, double) { return 0.5 + 0.3 * x; }, 0.02, 2 * seed + 1));
    ASSERT_TRUE(a && b);
    const MeasuredValue angle = angle_deg(*a, *b);
    squares += std::pow((angle.value - std::atan(0.3) * 180 / std::numbers::pi) / angle.sd, 2);
  }
  EXPECT_NEAR(squares / kRuns, 1, 0.3);
}

struct Line {
  SurfacePatch points;
  std::vector<double> along_mm;
};

Line line_with_step(double height_mm, double at_mm, double slope, double noise_mm, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Line line;
  for (int i = 0; i < 120; ++i) {
    const double s = 0.05 * i;
    SurfacePoint point;
    point.untouched_mm = {s, 0, kFaceZMm};
    point.depth_mm = 0.4 + slope * s + (s > at_mm ? height_mm : 0) + noise_mm * normal(random);
    point.noise_mm = noise_mm;
    line.points.points.push_back(point);
    line.along_mm.push_back(s);
  }
  return line;
}

TEST(SurfacePatchTest, AStepIsFoundWithItsHeightAndHowSureThatIs) {
  double squares = 0;
  constexpr int kRuns = 200;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const Line line = line_with_step(-0.15, 2.5, 0.05, 0.01, seed);
    const auto step = step_height(line.points, line.along_mm);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->at_mm, 2.5, 0.3);
    squares += std::pow((step->height_mm.value + 0.15) / step->height_mm.sd, 2);
  }
  EXPECT_NEAR(squares / kRuns, 1, 0.35);
}

TEST(SurfacePatchTest, WithoutAStepNoneIsTold) {
  int told = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Line line = line_with_step(0, 2.5, 0.05, 0.01, seed);
    if (step_height(line.points, line.along_mm)) ++told;
  }
  EXPECT_LE(told, 10);
  const Line line = line_with_step(0.2, 2.5, 0, 0.01, 1);
  SurfacePatch few = line.points;
  few.points.resize(8);
  EXPECT_FALSE(
      step_height(few, std::vector<double>(line.along_mm.begin(), line.along_mm.begin() + 8)));
}

/// A line of 120 points over a profile, its own noise.
Line line_over(const std::function<double(double)>& depth_mm, double noise_mm, unsigned seed) {
  Line line = line_with_step(0, 0, 0, noise_mm, seed);
  for (std::size_t i = 0; i < line.along_mm.size(); ++i)
    line.points.points[i].depth_mm += depth_mm(line.along_mm[i]) - 0.4;
  return line;
}

TEST(SurfacePatchTest, WithoutTwoPlanesThereIsNoStep) {
  const std::vector<std::pair<const char*, std::function<double(double)>>> profiles{
      {"over a ball", [](double s) { return cap_depth(s - 3, 0, 4, 0.9); }},
      {"from a ball's middle", [](double s) { return cap_depth(s, 0, 4, 1.2); }},
      {"to a ball's flank", [](double s) { return cap_depth(s - 6, 0, 3, 1.4); }},
      {"a ball beside the ends", [](double s) { return cap_depth(s - 1, 0, 2, 1.0); }},
      {"a fold", [](double s) { return std::max(0.0, 0.4 * (s - 3)); }},
      {"a wave", [](double s) { return 0.3 * std::sin(s); }},
      {"a narrow ridge", [](double s) { return s > 2.8 && s < 3.4 ? 0.5 : 0.0; }},
      {"a step near the end", [](double s) { return s > 5.8 ? 0.5 : 0.0; }}};
  for (const auto& [name, profile] : profiles)
    for (const double noise_mm : {0.0, 0.005, 0.02})
      for (unsigned seed = 0; seed < 20; ++seed) {
        const Line line = line_over(profile, noise_mm, seed);
        const auto step = step_height(line.points, line.along_mm);
        ASSERT_FALSE(step) << name << ", noise " << noise_mm << ": " << step->height_mm.value;
        EXPECT_FALSE(step.error().what.empty());
      }
}

TEST(SurfacePatchTest, AStepIsNoDeeperThanWhatItIsToldFrom) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  int told = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const double a = unit(random), b = unit(random), c = unit(random), at = 3 + 2 * unit(random);
    const Line line = line_over(
        [&](double s) {
          return a * std::sin(s * (1 + std::abs(b))) * std::abs(c) + (s > at ? 0.2 * b : 0.0);
        },
        0.01, seed);
    const auto step = step_height(line.points, line.along_mm);
    if (!step) continue;
    ++told;
    double low = 1e9, high = -1e9;
    for (const SurfacePoint& point : line.points.points)
      low = std::min(low, point.depth_mm), high = std::max(high, point.depth_mm);
    EXPECT_LE(std::abs(step->height_mm.value), high - low + 0.03) << seed;
    EXPECT_GT(step->height_mm.sd, 0);
  }
  EXPECT_GT(told, 20) << "no test of what is told";
}

TEST(SurfacePatchTest, WhatIsCutAtALimitIsNotMeasuredAsASurface) {
  Line line = line_with_step(0.3, 3, 0, 0.01, 1);
  ASSERT_TRUE(step_height(line.points, line.along_mm));
  line.points.points.back().is_limit = true;
  EXPECT_FALSE(step_height(line.points, line.along_mm));
  // A ball whose deepest part is cut flat has its radius from what is not.
  auto patch =
      pressed([](double x, double y) { return std::min(0.5, cap_depth(x, y, 3, 0.6)); }, 0, 1);
  for (SurfacePoint& point : patch.points) point.is_limit = point.depth_mm >= 0.5;
  const auto ball = fit_ball(patch);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->radius_mm.value, 3, 1e-6);
  EXPECT_FALSE(fit_plane(patch));
  EXPECT_FALSE(roughness(patch));
  EXPECT_TRUE(pressed_part(patch, 0.05)->is_lower_bound);
  EXPECT_FALSE(
      pressed_part(pressed([](double, double) { return 0.4; }, 0, 1), 0.05)->is_lower_bound);
}

}  // namespace
}  // namespace alltact::test
