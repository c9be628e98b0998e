#include "core/sensing/depth/light_spread.h"

#include "tests/support/made_press.h"

#include <cmath>
#include <random>

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
// scattering, thickness, the part of the light from within 0.15 and 0.5 mm, and the radius that
// holds four fifths.
struct Walked {
  double scattering_per_mm, layer_mm, within_015, within_05, four_fifths_mm;
};
constexpr Walked kWalked[] = {{0.4, 1.5, 0.58, 0.65, 1.5},
                              {0.6, 1.5, 0.49, 0.58, 1.6},
                              {1.2, 1.5, 0.29, 0.42, 1.7},
                              {0.6, 2.5, 0.30, 0.36, 3.0}};

TEST(LightSpread, WidthFollowsFromTheCoreAsInWalkedPaths) {
  for (const Walked& walked : kWalked) {
    LightSpread spread;
    spread.scattering = -std::log(walked.within_015);
    const double core = oblique_spread(spread, 1.0).core;
    EXPECT_NEAR(core, walked.within_015, 1e-12);
    const double width_mm = skirt_width_mm(spread, walked.layer_mm);
    EXPECT_NEAR(core + (1 - core) * within(0.5, width_mm), walked.within_05, 0.04);
    EXPECT_NEAR(core + (1 - core) * within(walked.four_fifths_mm, width_mm), 0.8, 0.04);
  }
}

MappingParameters spreading(double scattering, double a_mm, double b) {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.a_mm = a_mm;
  mapping.b = b;
  mapping.x_max = 0.6;
  mapping.spread.scattering = scattering;
  mapping.spread.b_straight = b;
  return mapping;
}

/// A indentation with a flat and a round part, by the position on the face, mm.
double indentation(double s_mm, double w_mm) {
  const double r = std::hypot(s_mm, w_mm), beside = std::hypot(s_mm - 4.0, w_mm - 1.0);
  return 0.35 / (1.0 + std::exp((r - 1.5) / 0.3)) + 0.2 * std::exp(-beside * beside / 0.8);
}

/// The indentation's mean over the skirt, summed over rings around a place.
double beside(double s_mm, double w_mm, double width_mm) {
  constexpr int kRings = 60, kSectors = 24;
  double sum = 0, all = 0;
  for (int i = 0; i < kRings; ++i) {
    const double from = 8.0 * width_mm * i / kRings, to = 8.0 * width_mm * (i + 1) / kRings;
    const double part =
        i == 0 ? within(to, width_mm) : within(to, width_mm) - within(from, width_mm);
    for (int k = 0; k < kSectors; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.5 * (i % 2)) / kSectors, r = 0.5 * (from + to);
      sum += part / kSectors * indentation(s_mm + r * std::cos(angle), w_mm + r * std::sin(angle));
    }
    all += part;
  }
  return sum / all;
}

Difference empty_difference(const cv::Size& size) {
  Difference difference;
  difference.x = cv::Mat(size, CV_32FC1, cv::Scalar(0.0));
  difference.flags = cv::Mat(size, CV_8UC1, cv::Scalar(kMeasured));
  return difference;
}

TEST(LightSpread, RemovalGivesTheDentOfAnEvenFaceSeenAlongItsNormal) {
  const MadeScene scene = flat_scene();
  for (const double scattering : {0.3, 0.7, 1.2}) {
    const MappingParameters mapping = spreading(scattering, 2.0, 0.5);
    const double core = std::exp(-scattering), width_mm = 1.5 * 0.6 / std::sqrt(scattering);
    Difference difference = empty_difference({400, 300});
    cv::Mat truth = difference.x.clone();
    for (int v = 0; v < 300; ++v)
      for (int u = 0; u < 400; ++u) {
        const double s = 0.05 * (u - 200), w = 0.05 * (v - 150);
        truth.at<float>(v, u) = static_cast<float>(indentation(s, w));
        if (v % 4 == 0 && u % 4 == 0)
          difference.x(cv::Rect(u, v, 4, 4)) = (1 - core) * beside(s + 0.075, w + 0.075, width_mm);
      }
    difference.x += core * truth;
    const cv::Mat before = difference.x.clone();
    remove_light_spread(mapping, scene.shape, &difference);
    const double off_before = cv::norm(before, truth, cv::NORM_L2),
                 off_after = cv::norm(difference.x, truth, cv::NORM_L2);
    EXPECT_LT(off_after, 0.3 * off_before) << scattering;
    // In the middle of the indentation, and 0.7 mm beside it.
    EXPECT_NEAR(difference.x.at<float>(150, 200), indentation(0, 0), 0.02) << scattering;
    EXPECT_NEAR(difference.x.at<float>(150, 156), indentation(-2.2, 0), 0.012) << scattering;
  }
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
