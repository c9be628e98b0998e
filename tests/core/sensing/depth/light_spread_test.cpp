#include "core/sensing/depth/light_spread.h"

#include "tests/support/made_press.h"
#include "tests/support/walked_layer.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

/// Part of the skirt's light from within r: 1 - z K1(z), the integral of K0.
double within(double r_mm, double width_mm) {
  const double z = r_mm / width_mm;
  return 1.0 - z * std::cyl_bessel_k(1, z);
}

// Paths of light walked backwards through layers over black, sight along the normal: reduced
// scattering, thickness, and the part of the light from within a radius.
struct Walked {
  double scattering_per_mm, layer_mm, radius_mm, within;
};
constexpr Walked kWalked[] = {{0.4, 1.5, 0.5, 0.65}, {0.4, 1.5, 1.5, 0.8},  {0.6, 1.5, 0.5, 0.58},
                              {0.6, 1.5, 1.6, 0.8},  {1.2, 1.5, 0.5, 0.42}, {1.2, 1.5, 1.7, 0.8},
                              {0.6, 2.5, 3.0, 0.8}};

TEST(LightSpread, CoreAndSkirtHoldAsMuchLightAsWalkedPaths) {
  for (const Walked& walked : kWalked) {
    LightSpread spread;
    spread.optical_thickness = walked.scattering_per_mm * walked.layer_mm;
    const double core = oblique_spread(spread, 1.0).core,
                 skirt = within(walked.radius_mm, skirt_width_mm(spread, walked.layer_mm));
    EXPECT_NEAR(core + (1 - core) * skirt, walked.within, 0.045)
        << walked.scattering_per_mm << " per mm, " << walked.radius_mm << " mm";
  }
}

// Even layers of isotropic scattering over black by the integral equation of transfer (160 cells),
// 1 % absorbed: optical thickness, cos of sight, and 1 + b of the Moebius curve through depths up
// to 0.6 of the layer over that for sight and light along the normal. 1 / cos of the light less 1
// is 0.7 of that of sight.
struct ObliqueCurve {
  double optical_thickness, cos_sight, factor;
};
constexpr ObliqueCurve kObliqueCurves[] = {{0.5, 0.8, 1.085}, {0.5, 0.6, 1.247}, {1.0, 0.8, 1.153},
                                           {1.0, 0.6, 1.465}, {2.0, 0.8, 1.249}, {2.0, 0.6, 1.756},
                                           {3.0, 0.8, 1.296}, {3.0, 0.6, 1.855}};

TEST(LightSpread, CurvesOfObliqueSightAreThoseOfTheEquationOfTransfer) {
  for (const ObliqueCurve& solved : kObliqueCurves) {
    LightSpread spread;
    spread.optical_thickness = solved.optical_thickness;
    EXPECT_NEAR(oblique_spread(spread, solved.cos_sight).b_factor / solved.factor, 1.0, 0.06)
        << solved.optical_thickness << ' ' << solved.cos_sight;
  }
}

MappingParameters spreading(double optical_thickness, double a_mm, double b) {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.a_mm = a_mm;
  mapping.b = b;
  mapping.x_max = 0.6;
  mapping.spread.optical_thickness = optical_thickness;
  mapping.spread.b_straight = b;
  return mapping;
}

Difference empty_difference(const cv::Size& size) {
  Difference difference;
  difference.x = cv::Mat(size, CV_32FC1, cv::Scalar(0.0));
  difference.flags = cv::Mat(size, CV_8UC1, cv::Scalar(kMeasured));
  return difference;
}

/// What a walked layer shows of a round indentation, on the flat scene.
Difference walked_difference(const WalkedLayer& layer, const std::function<double(double)>& depth) {
  const ShownRound shown(layer, depth, 8.0);
  Difference difference = empty_difference({400, 300});
  for (int v = 0; v < 300; ++v)
    for (int u = 0; u < 400; ++u)
      difference.x.at<float>(v, u) =
          static_cast<float>(shown.at(0.05 * std::hypot(u - 200, v - 150)));
  return difference;
}

/// The Moebius curve through what two even layers show.
MappingParameters curve_of_even_layers(const WalkedLayer& layer) {
  const auto shown = [&](double depth_mm) {
    return layer.difference([&](double, double) { return depth_mm; });
  };
  const double x1 = shown(0.25), x2 = shown(0.6);  // d (1 + b x) = a x
  const double b = (0.25 / x1 - 0.6 / x2) / (0.6 - 0.25);
  return spreading(0, 0.25 * (1.0 + b * x1) / x1, b);
}

TEST(LightSpread, RemovalGivesTheDepthOfAWalkedLayer) {
  const MadeScene scene = flat_scene();
  for (const double optical : {0.8, 1.6}) {
    const WalkedLayer layer(1.5, optical, 0.6, 12000, 3);
    MappingParameters mapping = curve_of_even_layers(layer);
    for (const double flat_mm : {1.0, 2.0}) {
      const auto depth = [&](double r) { return 0.5 / (1.0 + std::exp((r - flat_mm) / 0.12)); };
      const auto depth_read = [&](const Difference& difference, double r) {
        const double x = difference.x.at<float>(150, 200 + static_cast<int>(std::lround(r / 0.05)));
        return mapping.a_mm * x / (1.0 + mapping.b * x);
      };
      const Difference before = walked_difference(layer, depth);
      Difference after = before;
      mapping.spread.optical_thickness = optical;
      mapping.spread.b_straight = mapping.b;
      remove_light_spread(mapping, scene.shape, &after);
      double off_before = 0, off_after = 0;
      for (double r = 0; r < 5.0; r += 0.1) {
        off_before += std::abs(depth_read(before, r) - depth(r)) / 50;
        off_after += std::abs(depth_read(after, r) - depth(r)) / 50;
      }
      EXPECT_LT(off_after, 0.6 * off_before) << optical << ' ' << flat_mm;
      EXPECT_NEAR(depth_read(after, flat_mm + 0.8), depth(flat_mm + 0.8), 0.03)
          << optical << ' ' << flat_mm;
    }
  }
}

// Detail as fine as the smoothing is partly lost. The told sd has the size of what is missing, and
// broad bodies are told to lose nothing.
TEST(LightSpread, WhatIsTooFineForRemovalIsTold) {
  const MadeScene scene = flat_scene();
  for (const double optical : {0.5, 1.0, 1.6}) {
    const WalkedLayer layer(1.5, optical, 0.6, 12000, 5);
    MappingParameters mapping = curve_of_even_layers(layer);
    mapping.spread.optical_thickness = optical;
    mapping.spread.b_straight = mapping.b;
    /// Errors and told sd of a body's depth around its middle, root mean square, mm.
    struct Loss {
      double found_mm, told_mm;
    };
    const auto loss_of = [&](const std::function<double(double)>& depth) {
      Difference difference = walked_difference(layer, depth);
      remove_light_spread(mapping, scene.shape, &difference);
      double found = 0, told = 0;
      int count = 0;
      for (int v = 130; v <= 170; ++v)
        for (int u = 180; u <= 220; ++u, ++count) {
          const double x = difference.x.at<float>(v, u);
          const double read_mm = mapping.a_mm * x / (1.0 + mapping.b * x);
          found += std::pow(read_mm - depth(0.05 * std::hypot(u - 200, v - 150)), 2);
          told += std::pow(difference.spread_removed.lost_mm.at<float>(v, u), 2);
        }
      return Loss{std::sqrt(found / count), std::sqrt(told / count)};
    };
    const Loss pin = loss_of([](double r) { return 0.4 / (1.0 + std::exp((r - 0.5) / 0.03)); });
    const Loss ball = loss_of([](double r) { return std::max(0.0, 0.5 - r * r / 8.0); });
    printf("[ figures  ] optical thickness %.1f: pin %.3f told %.3f, ball %.3f told %.3f mm\n",
           optical, pin.found_mm, pin.told_mm, ball.found_mm, ball.told_mm);
    EXPECT_GT(pin.found_mm, 0.02) << optical;
    EXPECT_LT(pin.found_mm, 1.4 * pin.told_mm) << optical;
    EXPECT_GT(pin.found_mm, 0.7 * pin.told_mm) << optical;
    EXPECT_LT(ball.told_mm, 0.01) << optical;
  }
}

TEST(LightSpread, EvenLayersShowWhatTheyShowWithoutSpread) {
  const MadeScene scene = flat_scene();
  for (const double y : {-0.1, 0.05, 0.3, 0.6}) {
    const cv::Mat even(300, 400, CV_64FC1, cv::Scalar(y));
    const cv::Mat shown = with_light_spread(even, spreading(0.7, 2.0, 0.5), scene.shape);
    EXPECT_LT(cv::norm(shown, even, cv::NORM_INF), 2e-4) << y;
  }
}

TEST(LightSpread, SightMeetsTheFirstSkinOnItsWay) {
  const auto even = [](double) { return 0.4; };
  EXPECT_NEAR(meeting_part(even, 0.4), 0.6, 1e-12);
  EXPECT_NEAR(meeting_part([](double) { return 0.0; }, 0.4), 1.0, 1e-12);
  EXPECT_NEAR(meeting_part([](double) { return -0.05; }, 0.0), 1.05, 1e-12);
  // part = 1 - (0.7 - 0.5 part) where part = 0.6.
  EXPECT_NEAR(meeting_part([](double part) { return 0.7 - 0.5 * part; }, 0.7), 0.6, 1e-9);
  // A pit that the line passes under before it meets another.
  const auto two = [](double part) {
    return 0.3 * std::exp(-std::pow((part - 0.5) / 0.05, 2)) +
           0.5 * std::exp(-std::pow((part - 0.8) / 0.05, 2));
  };
  double first = 0;  // by small steps
  for (double part = 0.3; part < 1.2 && first == 0; part += 1e-5)
    if (part >= 1.0 - two(part)) first = part;
  EXPECT_NEAR(meeting_part(two, 0.5), first, 0.02);
}

TEST(LightSpread, RemovalGivesBackWhatWasSpreadOnAnInclinedFace) {
  const MadeScene scene = finger_scene(30.0, 40.0);
  MappingParameters mapping = spreading(0.6, 1.5 * 2.0, 1.0);
  mapping.spread.log_b_along = 0.3;
  mapping.spread.middle_mm = 20.0, mapping.spread.half_mm = 15.0;
  cv::Mat y(540, 960, CV_64FC1, cv::Scalar(0.0));
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u) {
      const Eigen::Vector2d at = scene.shape.position_mm(u, v) - Eigen::Vector2d(22.0, 1.0);
      y.at<double>(v, u) = 0.3 / (1.0 + std::exp((at.norm() - 2.0) / 0.4));
    }
  const cv::Mat shown = with_light_spread(y, mapping, scene.shape);
  Difference difference = empty_difference({960, 540});
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u)
      difference.x.at<float>(v, u) = scene.shape.at(u, v)
                                         ? static_cast<float>(shown.at<double>(v, u))
                                         : std::numeric_limits<float>::quiet_NaN();
  cv::Mat as_float;
  y.convertTo(as_float, CV_32F);
  const cv::Mat mask = as_float > 0.01F;
  const double before = cv::norm(difference.x, as_float, cv::NORM_L2, mask);
  remove_light_spread(mapping, scene.shape, &difference);
  EXPECT_LT(cv::norm(difference.x, as_float, cv::NORM_L2, mask), 0.15 * before);
}

TEST(LightSpread, ChangesNothingWithLocalLightOrASecondTime) {
  const MadeScene scene = flat_scene();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-0.1F, 0.4F);
  Difference difference = empty_difference({400, 300});
  difference.x.forEach<float>([&](float& x, const int*) { x = 0; });
  for (int i = 0; i < 120000; ++i) difference.x.at<float>(i / 400, i % 400) = uniform(random);
  const cv::Mat before = difference.x.clone();
  remove_light_spread(spreading(0.0, 2.0, 0.5), scene.shape, &difference);
  EXPECT_EQ(cv::norm(before, difference.x, cv::NORM_INF), 0.0);
  remove_light_spread(spreading(0.8, 2.0, 0.5), scene.shape, &difference);
  EXPECT_GT(cv::norm(before, difference.x, cv::NORM_INF), 0.05);
  const cv::Mat once = difference.x.clone();
  remove_light_spread(spreading(0.8, 2.0, 0.5), scene.shape, &difference);
  EXPECT_EQ(cv::norm(once, difference.x, cv::NORM_INF), 0.0);
}

TEST(LightSpread, StaysFiniteWhereAPixelIsMeasuredAndUnknownWhereNot) {
  const MadeScene scene = finger_scene(30.0, 35.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
  for (const double scattering : {0.02, 0.6, 2.5}) {
    Difference difference = empty_difference({960, 540});
    const float nothing = std::numeric_limits<float>::quiet_NaN();
    for (int v = 0; v < 540; ++v)
      for (int u = 0; u < 960; ++u)
        difference.x.at<float>(v, u) = (u / 7 + v / 5) % 9 == 0 ? nothing : uniform(random);
    const cv::Mat before = difference.x.clone();
    remove_light_spread(spreading(scattering, 2.0, 3.0), scene.shape, &difference);
    int different = 0;
    for (int v = 0; v < 540; ++v)
      for (int u = 0; u < 960; ++u)
        different +=
            std::isfinite(before.at<float>(v, u)) != std::isfinite(difference.x.at<float>(v, u));
    EXPECT_EQ(different, 0) << scattering;
  }
}

TEST(LightSpread, DifferencesAtAnAngleMeanTheSameDepthOnTheCurve) {
  for (const double b : {0.05, 0.8, 2.5}) {
    const MappingParameters mapping = spreading(0.7, 1.8 * (1 + b), b);
    for (const double b_here : {0.02, 0.8, 4.0})
      for (const double depth_mm : {-0.05, 0.02, 0.3, 0.9}) {
        const double x = depth_mm / (1.8 * (1 + b_here) - b_here * depth_mm);
        const double y = difference_on_curve(x, b_here, mapping);
        EXPECT_NEAR(mapping.a_mm * y / (1 + b * y), depth_mm, 1e-12) << b << ' ' << b_here;
      }
  }
}

}  // namespace
}  // namespace alltact
