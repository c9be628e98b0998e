#include "calibration/twin/twin.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A picture from 60 to 180 grey levels with noise of variance read^2 + gain * level and a pattern.
NoisyImage noisy(double read_sd, double gain, const cv::Mat_<float>& pattern, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  cv::Mat_<std::uint8_t> grey(240, 320);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) {
      const double level = (60 + 120.0 * u / 320) * (1 + pattern(v, u));
      grey(v, u) = cv::saturate_cast<std::uint8_t>(
          level + std::sqrt(read_sd * read_sd + gain * level) * normal(random));
    }
  return {grey, cv::Mat(grey.size(), CV_8UC1, cv::Scalar(255))};
}

cv::Mat_<float> pattern_of(double prnu) {
  std::mt19937 random(99);
  std::normal_distribution<double> normal;
  cv::Mat_<float> pattern(240, 320);
  for (float& value : pattern) value = static_cast<float>(prnu * normal(random));
  return pattern;
}

TEST(TwinNoise, OfPairsIsToldApartFromAFixedPattern) {
  const cv::Mat_<float> pattern = pattern_of(0.01);
  const std::vector<NoisyImage> pair{noisy(0.8, 0.02, pattern, 1), noisy(0.8, 0.02, pattern, 2)};
  const TwinNoise noise = measure_noise(pair, pair, "");
  EXPECT_NEAR(noise.shot_gain, 0.02, 0.002);
  EXPECT_NEAR(noise.read_sd, 0.8, 0.12);
  EXPECT_NEAR(noise.prnu, 0.01, 0.0007);
  ASSERT_TRUE(noise.shot_gain_sd && noise.read_sd_sd && noise.prnu_sd);
  EXPECT_LT(std::abs(noise.shot_gain - 0.02), 4 * *noise.shot_gain_sd);
}

TEST(TwinNoise, OfOnePictureHoldsThePatternAndSaysSo) {
  const std::vector<NoisyImage> one{noisy(1.0, 0, pattern_of(0), 3)};
  const TwinNoise noise = measure_noise({}, one, "");
  EXPECT_EQ(noise.shot_gain, 0);
  EXPECT_EQ(noise.prnu, 0);
  EXPECT_NEAR(noise.read_sd, 1.0, 0.03);
  EXPECT_NE(noise.from.english().find("cannot be separated"), std::string::npos);
}

TEST(TwinNoise, DotsAndScratchesAreNoNoise) {
  NoisyImage one = noisy(0.7, 0, pattern_of(0), 4);
  for (int i = 0; i < 200; ++i) one.grey.at<std::uint8_t>(11 + i, 20 + i) = 0;
  EXPECT_NEAR(measure_noise({}, {one}, "").read_sd, 0.7, 0.05);
}

}  // namespace
}  // namespace alltact
