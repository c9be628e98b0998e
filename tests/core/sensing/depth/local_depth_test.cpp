#include "core/sensing/depth/depth_map.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

Camera flat_camera(int width, int height) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = width, p.height_px = height;
  p.cx_px = 0.5 * (width - 1), p.cy_px = 0.5 * (height - 1);
  p.mm_per_px = 0.05;
  return Camera::create(p).value();
}

FaceShape flat_shape(int width, int height) {
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 2.0;
  return FaceShape::plane(flat_camera(width, height), face);
}

Reference reference_of(const cv::Mat& grey) {
  cv::Mat levels;
  grey.convertTo(levels, CV_32F);
  Reference reference;
  reference.image = ReferenceImage(levels);
  return reference;
}

Mapping straight(double mm_per_unit, MappingAlong along = MappingAlong::kZ) {
  MappingParameters p;
  p.along = along;
  p.x_max = 0.5;
  p.chebyshev = {mm_per_unit};
  return Mapping::create(p).value();
}

TEST(LocalDepth, EveryPairOfGreyLevelsIsFiniteOrFlagged) {
  cv::Mat live(256, 256, CV_8UC1), untouched(256, 256, CV_8UC1);
  for (int i = 0; i < 256; ++i)
    for (int k = 0; k < 256; ++k)
      live.at<std::uint8_t>(i, k) = static_cast<std::uint8_t>(i),
                               untouched.at<std::uint8_t>(i, k) = static_cast<std::uint8_t>(k);
  const FaceShape shape = flat_shape(256, 256);
  for (const double smoothing : {0.0, 1.5}) {
    DifferenceOptions options;
    options.smoothing = gaussian_smoothing(smoothing);
    const Difference diff = difference(live, reference_of(untouched), shape, options);
    const DepthMap map = depth_map(diff, straight(3.0), shape);
    for (int i = 0; i < 256; ++i) {
      for (int k = 0; k < 256; ++k) {
        const auto flag = map.flags.at<std::uint8_t>(i, k);
        const float d = map.depth_mm.at<float>(i, k);
        const bool measured = flag == kMeasured || flag == kExtrapolated || is_at_limit(flag);
        ASSERT_EQ(std::isfinite(d), measured) << i << ' ' << k;
        if (measured) {
          ASSERT_LE(std::abs(static_cast<double>(d)), shape.face().layer_mm + 1e-6);
        }
        if (flag == kBulgeLimit) {
          ASSERT_EQ(d, -static_cast<float>(shape.face().layer_mm));
        }
        if (k < 8) {
          ASSERT_EQ(flag, kTooDark);
        }
        if (k >= 250 || (i >= 250 && k >= 8)) {
          ASSERT_EQ(flag, kSaturated);
        }
        if (measured && smoothing == 0.0) {
          const double x = static_cast<double>(k - i) / k;  // in double, of the whole numbers
          ASSERT_NEAR(static_cast<double>(diff.x.at<float>(i, k)), x, 2e-7 * (1.0 + std::abs(x)));
          ASSERT_EQ(flag == kExtrapolated || flag == kBeyondLayer, static_cast<float>(x) > 0.5F)
              << i << ' ' << k;
        }
      }
    }
  }
}

// Nearly overexposed, noise clips every other pixel, and amid clipped ones hardly any of the
// kernel is left: what remains measured must stay near the truth, which is that nothing touches.
TEST(LocalDepth, SpecksAmidClippedPixelsAreNoMeasurement) {
  constexpr int kWidth = 320, kHeight = 240;
  constexpr double kNoiseGrey = 3.0;
  const FaceShape shape = flat_shape(kWidth, kHeight);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, kNoiseGrey);
    cv::Mat live(kHeight, kWidth, CV_8UC1), untouched(kHeight, kWidth, CV_8UC1);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const double level = 225.0 + 40.0 * u / kWidth;
        live.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(level + noise(engine));
        untouched.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(level + noise(engine));
      }
    DifferenceOptions options;
    options.smoothing = smoothing_of(1.0);
    const Difference diff = difference(live, reference_of(untouched), shape, options);
    int measured = 0, thin = 0;
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const auto x = static_cast<double>(diff.x.at<float>(v, u));
        const auto flag = diff.flags.at<std::uint8_t>(v, u);
        ASSERT_EQ(std::isfinite(x), flag == kMeasured) << u << ' ' << v;
        const bool unclipped =
            live.at<std::uint8_t>(v, u) < 250 && untouched.at<std::uint8_t>(v, u) < 250;
        if (flag != kMeasured) {
          EXPECT_EQ(flag, kSaturated);
          thin += unclipped;
          continue;
        }
        ++measured;
        // A fifth of the kernel averages at least over a few pixels.
        ASSERT_LT(std::abs(x), 8.0 * kNoiseGrey / 225.0) << u << ' ' << v << " seed " << seed;
      }
    EXPECT_GT(measured, kWidth * kHeight / 2);
    EXPECT_GT(thin, 0);
  }
}

TEST(LocalDepth, SmoothingDoesNotBendAtTheFacesEdge) {
  // a constant ratio over uneven light stays that ratio, up to the last pixel of the face
  const int width = 120, height = 90;
  cv::Mat live(height, width, CV_8UC1), untouched(height, width, CV_8UC1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      untouched.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(2 * (30 + u / 4)),
                                    live.at<std::uint8_t>(v, u) =
                                        cv::saturate_cast<std::uint8_t>(30 + u / 4);
  DifferenceOptions options;
  options.smoothing = gaussian_smoothing(2.0);
  const Difference diff =
      difference(live, reference_of(untouched), flat_shape(width, height), options);
  double low = 1, high = 0;
  cv::minMaxLoc(diff.x, &low, &high);
  // Two passes of five products, each rounded to 1/64 grey level, of a level of 60.
  constexpr double kRounding = 2 * 5 * 0.5 / 64 / 60;
  EXPECT_NEAR(low, 0.5, kRounding);
  EXPECT_NEAR(high, 0.5, kRounding);
}

TEST(LocalDepth, NoiseIsAsPredictedAndUnbiased) {
  const int width = 400, height = 300;
  const double level = 60.0, sd = 1.0, x_true = 0.2;
  std::mt19937 engine(4);
  std::normal_distribution<double> noise(0.0, sd);
  cv::Mat live(height, width, CV_8UC1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      live.at<std::uint8_t>(v, u) =
          cv::saturate_cast<std::uint8_t>(std::lround(level * (1.0 - x_true) + noise(engine)));
  Reference reference = reference_of(cv::Mat(height, width, CV_8UC1, cv::Scalar(level)));
  reference.noise_gain = 0.0;
  DifferenceOptions options;
  options.smoothing = gaussian_smoothing(1.5);
  options.noise_sd = std::sqrt(sd * sd + 1.0 / 12.0);
  const Difference diff = difference(live, reference, flat_shape(width, height), options);
  cv::Scalar mean, spread;
  cv::meanStdDev(diff.x, mean, spread);
  EXPECT_NEAR(mean[0], x_true, 1e-3);
  EXPECT_NEAR(spread[0], diff.grey_sd / level, 0.05 * diff.grey_sd / level);
}

TEST(LocalDepth, ABulgeIsADepthBelowZero) {
  cv::Mat untouched(60, 80, CV_8UC1, cv::Scalar(100)), live(60, 80, CV_8UC1, cv::Scalar(112));
  const FaceShape shape = flat_shape(80, 60);
  const DepthMap map =
      depth_map(difference(live, reference_of(untouched), shape, {}), straight(5.0), shape);
  double least = 0, most = 0;
  cv::minMaxLoc(map.depth_mm, &least, &most);
  EXPECT_NEAR(least, -0.12 * 5.0, 0.005);  // brightness comes in steps
  EXPECT_NEAR(most, -0.12 * 5.0, 0.005);
  EXPECT_EQ(cv::countNonZero(map.flags), 0);
}

TEST(LocalDepth, ReferenceDecidesWhereThereIsAFace) {
  const cv::Mat live(60, 80, CV_8UC1, cv::Scalar(80));
  cv::Mat levels(60, 80, CV_32FC1, cv::Scalar(100));
  levels(cv::Rect(0, 0, 20, 60)) = std::numeric_limits<float>::quiet_NaN();
  Reference reference;
  reference.image = ReferenceImage(levels);
  const FaceShape shape = flat_shape(80, 60);
  const DepthMap map = depth_map(difference(live, reference, shape, {}), straight(5.0), shape);
  for (int u = 0; u < 80; ++u) {
    EXPECT_EQ(map.flags.at<std::uint8_t>(30, u), u < 20 ? kNoReference : kMeasured);
    if (u < 20) {
      EXPECT_TRUE(std::isnan(map.depth_mm.at<float>(30, u)));
    } else {
      EXPECT_NEAR(static_cast<double>(map.depth_mm.at<float>(30, u)), 1.0, 2e-3);
    }
  }
}

}  // namespace
}  // namespace alltact
