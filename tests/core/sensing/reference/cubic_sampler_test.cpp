#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kAcross = 90, kDown = 70;
constexpr double kRoundedBy = 0.5 / 2048;
constexpr double kLevelError = 0.5 + 0.2;  // of rounding to whole levels, and before

template <class Level>
cv::Mat drawn(Level level) {
  cv::Mat grey(kDown, kAcross, CV_8UC1);
  for (int v = 0; v < kDown; ++v)
    for (int u = 0; u < kAcross; ++u)
      grey.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(std::lround(level(u, v)));
  return grey;
}

struct Places {
  std::vector<float> u, v;
};

/// Places in a row that are about a pixel apart, as a warp of the face makes them.
Places row_of(std::mt19937& random, int count, double reach) {
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const double stretch = 1.0 + 0.2 * part(random), slope = 0.3 * part(random);
  const double u = 0.5 * (kAcross - stretch * count) + reach * kAcross * part(random),
               v = 0.5 * kDown * (1.0 + (0.8 + reach) * part(random)), bow = 2e-3 * part(random);
  Places places;
  for (int i = 0; i < count; ++i) {
    places.u.push_back(static_cast<float>(u + i * stretch));
    places.v.push_back(static_cast<float>(v + i * (slope + bow * i)));
  }
  return places;
}

std::vector<std::uint8_t> levels_at(const cv::Mat& grey, const Places& places) {
  std::vector<std::uint8_t> levels(places.u.size());
  CubicSampler(grey).sample(places.u.data(), places.v.data(), static_cast<int>(levels.size()),
                            levels.data());
  return levels;
}

/// Keys' kernel for a = -1/2, as it is written down, by distance.
double kernel(double distance) {
  const double x = std::abs(distance);
  if (x < 1.0) return 1.5 * x * x * x - 2.5 * x * x + 1.0;
  return x < 2.0 ? -0.5 * x * x * x + 2.5 * x * x - 4.0 * x + 2.0 : 0.0;
}

double plain(const cv::Mat& grey, double u, double v) {
  double level = 0;
  const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
  for (int y = top - 1; y <= top + 2; ++y)
    for (int x = left - 1; x <= left + 2; ++x)
      level += kernel(x - u) * kernel(y - v) *
               grey.at<std::uint8_t>(std::clamp(y, 0, kDown - 1), std::clamp(x, 0, kAcross - 1));
  return std::clamp(level, 0.0, 255.0);
}

TEST(CubicSampler, IsThePlainFormulaAtPlacesInAndBesideThePicture) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(0, 255);
  const cv::Mat grey = drawn([&](int, int) { return any(random); });
  for (const double reach : {0.0, 0.3, 1.5})
    for (int trial = 0; trial < 200; ++trial) {
      const Places places = row_of(random, 1 + trial % 80, reach);
      const auto levels = levels_at(grey, places);
      for (std::size_t i = 0; i < levels.size(); ++i) {
        const auto u = static_cast<double>(places.u[i]), v = static_cast<double>(places.v[i]);
        // By how much a place that is off by its rounding may change it.
        double off = 0;
        for (const double du : {-kRoundedBy, kRoundedBy})
          for (const double dv : {-kRoundedBy, kRoundedBy})
            off = std::max(off, std::abs(plain(grey, u + du, v + dv) - plain(grey, u, v)));
        EXPECT_NEAR(levels[i], plain(grey, u, v), kLevelError + off) << u << " " << v;
      }
    }
}

/// What is looked up in a picture of levels, less these, at places away from its border.
template <class Level>
std::vector<double> errors_inside(unsigned seed, Level level) {
  const cv::Mat grey = drawn(level);
  std::mt19937 random(seed);
  std::vector<double> errors;
  for (int trial = 0; trial < 100; ++trial) {
    const Places places = row_of(random, 40, 0.0);
    const auto levels = levels_at(grey, places);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const auto u = static_cast<double>(places.u[i]), v = static_cast<double>(places.v[i]);
      if (u < 2 || v < 2 || u > kAcross - 4 || v > kDown - 4) continue;
      errors.push_back(levels[i] - level(u, v));
    }
  }
  EXPECT_GT(errors.size(), 1000);
  return errors;
}

TEST(CubicSampler, KeepsEvenSlopesWhereTheyAre) {
  const auto errors = errors_inside(6, [](double u, double v) { return 40.0 + u + 2.0 * v; });
  double sum = 0;
  for (const double error : errors) {
    EXPECT_NEAR(error, 0.0, kLevelError);
    sum += error;
  }
  EXPECT_NEAR(sum / static_cast<double>(errors.size()), 0.0, 0.03);
}

TEST(CubicSampler, SharpensAndBlursNothingThatIsTwelvePixelsWide) {
  const auto errors = errors_inside(7, [](double u, double v) {
    return 128.0 + 100.0 * std::sin(2 * std::numbers::pi * (0.8 * u + 0.6 * v) / 12.0);
  });
  double square = 0;
  for (const double error : errors) square += error * error;
  EXPECT_LT(std::sqrt(square / static_cast<double>(errors.size())), 1.0);  // of 100
}

TEST(CubicSampler, OfOnePixelIsThatPixel) {
  const cv::Mat grey(1, 1, CV_8UC1, cv::Scalar(77));
  const std::array<float, 3> u{-1e6F, 0.3F, 1e6F}, v{1e6F, -0.4F, -1e6F};
  std::array<std::uint8_t, 3> levels{};
  CubicSampler(grey).sample(u.data(), v.data(), 3, levels.data());
  EXPECT_EQ(levels, (std::array<std::uint8_t, 3>{77, 77, 77}));
}

}  // namespace
}  // namespace alltact
