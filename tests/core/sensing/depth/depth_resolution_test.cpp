#include "core/sensing/depth/depth_resolution.h"

#include "core/sensing/depth/light_spread.h"
#include "tests/support/made_press.h"
#include "tests/support/walked_layer.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

constexpr double kPixelMm = 0.05;  // of the flat scene

MappingParameters local_mapping() {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.a_mm = 2.0;
  mapping.b = 0.5;
  mapping.x_max = 0.6;
  return mapping;
}

DepthResolution resolution_of(const MappingParameters& mapping, const Smoothing& smoothing) {
  const MadeScene scene = flat_scene();
  return depth_resolution_at(scene.shape, scene.shape.position_mm(200, 150), mapping, smoothing)
      .value();
}

TEST(DepthResolution, FollowsFromTheBlurWhereLightIsLocal) {
  constexpr double kSdPx = 2.0;
  Smoothing smoothing;  // a normal curve to its twelfth digit
  smoothing.weights.clear();
  for (int i = 0; i < 16; ++i)
    smoothing.weights.push_back(std::exp(-0.5 * std::pow(i / kSdPx, 2)) /
                                (kSdPx * std::sqrt(2 * std::numbers::pi)));
  const DepthResolution resolution = resolution_of(local_mapping(), smoothing);
  const double sd = std::sqrt(kSdPx * kSdPx + kOpticsPx2) * kPixelMm;
  // Quantiles of the normal distribution, and of Rayleigh's.
  EXPECT_NEAR(resolution.step_mm, 1.281552 * sd, 0.01 * sd);
  EXPECT_NEAR(resolution.wall_mm, 2 * 1.644854 * sd, 0.02 * sd);
  EXPECT_NEAR(resolution.pin_mm, 2 * std::sqrt(2 * std::log(10.0)) * sd, 0.02 * sd);
  // Two normal curves this far apart dip to 0.8 of their highest (50 digits: 2.65929980610...).
  EXPECT_NEAR(resolution.two_points_mm, 2.659300 * sd, 0.02 * sd);
  ASSERT_EQ(resolution.contrasts.size(), std::size_t{DepthResolution::kWaves});
  for (int i = 0; i < DepthResolution::kWaves; ++i)
    EXPECT_NEAR(
        resolution.contrasts[static_cast<std::size_t>(i)],
        std::exp(-0.5 * std::pow(2 * std::numbers::pi * DepthResolution::wave_per_mm(i) * sd, 2)),
        2e-3);
}

TEST(DepthResolution, TwoPointsNeedAPixelBetweenThem) {
  MappingParameters mapping = local_mapping();
  Smoothing sharper;  // nearer points would differ by its contrast alone
  sharper.weights = {1.8, -0.4};
  EXPECT_NEAR(resolution_of(mapping, sharper).two_points_mm, 2 * kPixelMm, 1e-3);
}

TEST(DepthResolution, SmoothingCoarsensIt) {
  double before = 0;
  for (const double px : {0.0, 1.0, 2.0, 4.0}) {
    const double two_points_mm = resolution_of(local_mapping(), smoothing_of(px)).two_points_mm;
    EXPECT_GT(two_points_mm, before) << px;
    before = two_points_mm;
  }
}

MappingParameters spreading(double optical) {
  MappingParameters mapping = local_mapping();
  mapping.spread.optical_thickness = optical;
  mapping.spread.b_straight = mapping.b;
  return mapping;
}

/// An image whose brightness difference at a pixel is that of `shown`, by mm from the middle along
/// and across, with its spread light removed.
template <class Shown>
cv::Mat measured(const MappingParameters& mapping, const Shown& shown) {
  const MadeScene scene = flat_scene();
  Difference difference;
  difference.flags = cv::Mat(300, 400, CV_8UC1, cv::Scalar(kMeasured));
  difference.x = cv::Mat(300, 400, CV_32FC1);
  for (int v = 0; v < 300; ++v)
    for (int u = 0; u < 400; ++u)
      difference.x.at<float>(v, u) =
          static_cast<float>(shown(kPixelMm * (u - 200), kPixelMm * (v - 150)));
  remove_light_spread(mapping, scene.shape, &difference);
  return difference.x;
}

TEST(DepthResolution, IsThatOfWavesOnWalkedLayers) {
  for (const double optical : {0.8, 1.6}) {
    const WalkedLayer layer(1.5, optical, 0.6, 20000, 5);
    const MappingParameters mapping = spreading(optical);
    const DepthResolution resolution = resolution_of(mapping, {});
    const double even = layer.difference([](double, double) { return 0.2; });
    for (const int wave : {3, 5, 7, 10}) {
      const double k = 2 * std::numbers::pi * DepthResolution::wave_per_mm(wave);
      constexpr std::size_t kPhases = 24;
      std::vector<double> by_phase;
      for (std::size_t phase = 0; phase < kPhases; ++phase)
        by_phase.push_back(layer.difference([&](double x, double) {
          return 0.1 + 0.1 * std::cos(k * x + 2 * std::numbers::pi * phase / kPhases);
        }));
      const cv::Mat x = measured(mapping, [&](double along, double) {
        const double turns = k * along / (2 * std::numbers::pi);
        const double phase = (turns - std::floor(turns)) * kPhases;
        const auto i = static_cast<std::size_t>(phase) % kPhases;
        return std::lerp(by_phase[i], by_phase[(i + 1) % kPhases], phase - std::floor(phase));
      });
      const double period_px = 1.0 / (DepthResolution::wave_per_mm(wave) * kPixelMm);
      const int half = static_cast<int>(std::floor(120 / period_px) * period_px / 2);
      double cosine = 0, sine = 0;
      for (int u = 200 - half; u < 200 + half; ++u) {
        cosine += x.at<float>(150, u) * std::cos(k * kPixelMm * (u - 200));
        sine += x.at<float>(150, u) * std::sin(k * kPixelMm * (u - 200));
      }
      EXPECT_NEAR(std::hypot(cosine, sine) / half / (0.5 * even),
                  resolution.contrasts[static_cast<std::size_t>(wave)], 0.1)
          << optical << ' ' << wave;
    }
  }
}

TEST(DepthResolution, TwoPointsOnWalkedLayersAreSeenApartFromItsDistanceOn) {
  for (const double optical : {0.8, 1.6}) {
    const WalkedLayer layer(1.5, optical, 0.6, 40000, 6);
    const MappingParameters mapping = spreading(optical);
    const ShownRound indentation(
        layer, [](double r) { return 0.1 * std::exp(-0.5 * std::pow(r / 0.1, 2)); }, 8.0);
    double apart_mm = 0;  // the least distance
    for (int px = 40; px > 6 && apart_mm == 0; px -= 2) {
      const double half_mm = 0.5 * px * kPixelMm;
      const cv::Mat x = measured(mapping, [&](double along, double across) {
        return indentation.at(std::hypot(along - half_mm, across)) +
               indentation.at(std::hypot(along + half_mm, across));
      });
      double highest = 0;
      for (int u = 200 - px; u <= 200 + px; ++u)
        highest = std::max(highest, static_cast<double>(x.at<float>(150, u)));
      if (static_cast<double>(x.at<float>(150, 200)) > 0.8 * highest)
        apart_mm = (px + 1) * kPixelMm;
    }
    EXPECT_NEAR(resolution_of(mapping, {}).two_points_mm / apart_mm, 1.0, 0.15) << optical;
  }
}

}  // namespace
}  // namespace alltact
