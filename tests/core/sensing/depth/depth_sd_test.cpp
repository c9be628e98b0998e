// What is said of a pixel's depth, against how depths scatter when pictures and mappings do.
#include "core/sensing/depth/depth_sd.h"

#include "tests/support/made_press.h"

#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kSmallWidth = 160, kSmallHeight = 120;

struct Bench {
  made::MadeScene scene = made::flat_scene(0.05, kSmallWidth, kSmallHeight);
  MappingParameters parameters;
  cv::Mat truth =
      cv::Mat(kSmallHeight, kSmallWidth, CV_32FC1);  // grey levels of the untouched face
  std::mt19937_64 random{11};

  Bench() {
    parameters.kind = MappingKind::kMoebius;
    parameters.x_max = 0.6;
    parameters.a_mm = 2.6;
    parameters.b = 0.9;
    for (int v = 0; v < kSmallHeight; ++v)
      for (int u = 0; u < kSmallWidth; ++u)
        truth.at<float>(v, u) = 60.0F + 120.0F * static_cast<float>(u) / kSmallWidth;
  }
  /// How much darker a pixel is: nothing at the left, half at the right bottom.
  static double pressed(int u, int v) {
    return v < 20 ? 0.0 : 0.5 * u / kSmallWidth * v / kSmallHeight;
  }

  cv::Mat noisy(bool is_live, double sd) {
    std::normal_distribution<double> noise(0.0, sd);
    cv::Mat image(kSmallHeight, kSmallWidth, CV_8UC1);
    for (int v = 0; v < kSmallHeight; ++v)
      for (int u = 0; u < kSmallWidth; ++u)
        image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
            static_cast<double>(truth.at<float>(v, u)) * (is_live ? 1.0 - pressed(u, v) : 1.0) +
            noise(random));
    return image;
  }
  Reference reference(double sd) {
    cv::Mat levels;
    noisy(false, sd).convertTo(levels, CV_32F);
    Reference reference;
    reference.image = ReferenceImage(levels);
    return reference;
  }
};

TEST(DepthSd, IsHowDepthsScatter) {
  Bench bench;
  constexpr double kNoise = 2.0;
  constexpr int kRuns = 150;
  bench.parameters.covariance = (Eigen::Matrix2d() << 0.01, 0.004, 0.004, 0.004).finished();
  const Eigen::Matrix2d root = bench.parameters.covariance.llt().matrixL();
  std::normal_distribution<double> normal;
  DifferenceOptions options;
  options.smoothing = gaussian_smoothing(1.0);
  options.noise_sd = std::hypot(kNoise, std::sqrt(1.0 / 12.0));
  cv::Mat sum = cv::Mat::zeros(kSmallHeight, kSmallWidth, CV_64FC1), square = sum.clone(),
          told = sum.clone();
  const Mapping mapping = Mapping::create(bench.parameters).value();
  for (int run = 0; run < kRuns; ++run) {
    MappingParameters drawn = bench.parameters;
    const Eigen::Vector2d step = root * Eigen::Vector2d(normal(bench.random), normal(bench.random));
    drawn.a_mm += step[0], drawn.b += step[1];
    const Reference reference = bench.reference(kNoise);
    const cv::Mat live = bench.noisy(true, kNoise);
    const auto depth_of = [&](const Mapping& by) {
      return depth_map(live, reference, bench.scene.shape, options, by);
    };
    cv::Mat depth, sd;
    depth_of(Mapping::create(drawn).value()).depth_mm.convertTo(depth, CV_64F);
    depth_sd_mm(depth_of(mapping), reference, bench.scene.shape, mapping).convertTo(sd, CV_64F);
    sum += depth;
    square += depth.mul(depth);
    told += sd.mul(sd);
  }
  for (const cv::Rect& part :
       {cv::Rect(20, 60, 20, 40), cv::Rect(60, 60, 30, 40), cv::Rect(120, 70, 30, 40)}) {
    const cv::Mat mean = sum / kRuns;
    const cv::Mat variance = (square / kRuns - mean.mul(mean)) * (kRuns / (kRuns - 1.0));
    const double scattered = std::sqrt(cv::mean(variance(part))[0]);
    const double reported = std::sqrt(cv::mean(told(part))[0] / kRuns);
    EXPECT_NEAR(reported, scattered, 0.12 * scattered) << part;
  }
}

TEST(DepthSd, GrowsWhereTheFaceIsDarkAndIsAbsentWithTheDepth) {
  Bench bench;
  const Mapping mapping = Mapping::create(bench.parameters).value();
  const Reference reference = bench.reference(1.0);
  cv::Mat live = bench.noisy(true, 1.0);
  live(cv::Rect(100, 90, 10, 10)).setTo(255);
  const DepthMap depth = depth_map(live, reference, bench.scene.shape, {}, mapping);
  const cv::Mat sd = depth_sd_mm(depth, reference, bench.scene.shape, mapping);
  EXPECT_GT(cv::mean(sd(cv::Rect(10, 5, 20, 10)))[0],
            1.5 * cv::mean(sd(cv::Rect(130, 5, 20, 10)))[0]);
  for (int v = 0; v < kSmallHeight; ++v)
    for (int u = 0; u < kSmallWidth; ++u) {
      EXPECT_EQ(std::isfinite(sd.at<float>(v, u)), std::isfinite(depth.depth_mm.at<float>(v, u)));
      if (std::isfinite(sd.at<float>(v, u))) {
        EXPECT_GT(sd.at<float>(v, u), 0.0F);
      }
    }
}

}  // namespace
}  // namespace alltact
