#include "core/numerics/image_noise.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(PictureNoise, IsWhatWasAddedOnSmoothContent) {
  for (const double sd : {0.7, 1.0, 2.0, 4.0}) {
    std::mt19937 engine(7);
    std::normal_distribution<double> noise(0.0, sd);
    cv::Mat image(540, 960, CV_8UC1);
    for (int v = 0; v < image.rows; ++v)
      for (int u = 0; u < image.cols; ++u)
        image.at<std::uint8_t>(v, u) =
            cv::saturate_cast<std::uint8_t>(std::lround(60.0 + 0.1 * u + noise(engine)));
    const double expected = std::sqrt(sd * sd + 1.0 / 12.0);  // rounding adds its own
    EXPECT_NEAR(image_noise_sd(image), expected, 0.06 * expected) << sd;
  }
}

TEST(PictureNoise, EdgesAndClippedAreasDoNotCount) {
  std::mt19937 engine(11);
  std::normal_distribution<double> noise(0.0, 1.5);
  cv::Mat image(540, 960, CV_8UC1, cv::Scalar(0));
  for (int v = 0; v < image.rows; ++v)
    for (int u = 200; u < image.cols; ++u)
      image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
          std::lround(((u / 40) % 2 != 0 ? 180.0 : 60.0) + noise(engine)));
  EXPECT_NEAR(image_noise_sd(image), 1.5, 0.15);
}

TEST(PictureNoise, NeverLessThanQuantisation) {
  const double quantisation = std::sqrt(1.0 / 12.0);
  EXPECT_DOUBLE_EQ(image_noise_sd(cv::Mat(100, 100, CV_8UC1, cv::Scalar(128))), quantisation);
  EXPECT_DOUBLE_EQ(image_noise_sd(cv::Mat(100, 100, CV_8UC1, cv::Scalar(0))), quantisation);
  EXPECT_DOUBLE_EQ(image_noise_sd(cv::Mat(1, 1, CV_8UC1, cv::Scalar(128))), quantisation);
}

}  // namespace
}  // namespace alltact
