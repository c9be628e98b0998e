// What is laid over the live picture: the colours of the depth, and stripes where the measurement
// says that it cannot measure.
#include "calibration/live/live_finger.h"
#include "core/finger/finger_store.h"
#include "core/image/colour_map.h"
#include "core/image/grey_range.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"
#include "tests/support/flat_sensor.h"

#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using test::FlatSensor;
using Stripe = cv::Vec4b;

constexpr int kPeriod_px = 6;  // along a row, half of it painted
const cv::Rect kDarkReference(30, 40, 60, 48), kBrightReference(200, 30, 48, 60),
    kBrightLive(120, 150, 54, 42), kDarkLive(230, 150, 48, 48);

/// Patches of all levels between measurable and not, in the reference and in the live picture.
FrameResult measured(bool is_calibrated) {
  cv::Mat reference = test::untouched_picture(1), live = test::untouched_picture(2);
  const auto fill = [](cv::Mat& image, const cv::Rect& patch, int first) {
    for (int u = 0; u < patch.width; ++u) {
      const int level = first + u / kPeriod_px;
      image(cv::Rect(patch.x + u, patch.y, 1, patch.height)).setTo(level);
    }
  };
  fill(reference, kDarkReference, 3);      // 3 to 12
  fill(reference, kBrightReference, 246);  // 246 to 253
  fill(live, kBrightLive, 246);
  fill(live, kDarkLive, 0);  // 0 to 7: as dark as it likes
  Pipeline pipeline = Pipeline::with_library(
      ReferenceLibrary::single(reference).value(),
      FingerSnapshot::of({}, test::flat_sensor_finger(is_calibrated)).value(), PipelineSettings{});
  auto frame = std::make_shared<Frame>();
  frame->grey = live;
  frame->name = "frame";
  auto result = pipeline(frame);
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

const Stripe kNothing(0, 0, 0, 0);

/// The only colour within a patch of the layer but nothing; nothing where there are none or more.
Stripe colour_in(const cv::Mat& layer, const cv::Rect& patch) {
  Stripe found = kNothing;
  for (int v = patch.y; v < patch.br().y; ++v)
    for (int u = patch.x; u < patch.br().x; ++u) {
      const Stripe& here = layer.at<Stripe>(v, u);
      if (here == kNothing) continue;
      if (found != kNothing && found != here) return kNothing;
      found = here;
    }
  return found;
}

class FaultsLayer : public testing::TestWithParam<bool> {};

TEST_P(FaultsLayer, ShowsExactlyWhatTheMeasurementFlags) {
  const FrameResult result = measured(GetParam());
  ASSERT_EQ(result.depth.has_value(), GetParam());
  const cv::Mat& flags = result.depth ? result.depth->flags : result.difference->flags;
  const cv::Mat layer = faults_layer(result.grey, result);
  const Stripe dark = colour_in(layer, kDarkReference), bright = colour_in(layer, kBrightLive);
  ASSERT_NE(dark, kNothing);
  ASSERT_NE(bright, kNothing);
  ASSERT_NE(dark, bright);
  EXPECT_EQ(colour_in(layer, kBrightReference), bright);
  int dark_flags = 0, bright_flags = 0, dark_painted = 0, bright_painted = 0;
  for (int v = 0; v < layer.rows; ++v)
    for (int u = 0; u < layer.cols; ++u) {
      const auto flag = flags.at<std::uint8_t>(v, u);
      const Stripe& here = layer.at<Stripe>(v, u);
      dark_flags += flag == kTooDark, bright_flags += flag == kSaturated;
      dark_painted += here == dark, bright_painted += here == bright;
      ASSERT_TRUE(here == kNothing || here == (flag == kTooDark     ? dark
                                               : flag == kSaturated ? bright
                                                                    : kNothing))
          << u << ", " << v;
      // Every flagged stretch of half a period along a row has a painted pixel.
      if (u + kPeriod_px / 2 >= layer.cols || (flag != kTooDark && flag != kSaturated)) continue;
      bool is_even = true, is_painted = false;
      for (int k = 0; k <= kPeriod_px / 2; ++k) {
        is_even = is_even && flags.at<std::uint8_t>(v, u + k) == flag;
        is_painted = is_painted || layer.at<Stripe>(v, u + k) != kNothing;
      }
      ASSERT_TRUE(!is_even || is_painted) << u << ", " << v;
    }
  EXPECT_GT(dark_flags, 1000);
  EXPECT_GT(bright_flags, 1000);
  EXPECT_NEAR(dark_painted, 0.5 * dark_flags, 0.1 * dark_flags);
  EXPECT_NEAR(bright_painted, 0.5 * bright_flags, 0.1 * bright_flags);
}

INSTANTIATE_TEST_SUITE_P(Calibrated, FaultsLayer, testing::Bool());

TEST(LiveFaults, ADarkLivePictureIsNoFaultWhereItsReferenceIsBright) {
  const FrameResult result = measured(true);
  const cv::Mat layer = faults_layer(result.grey, result);
  EXPECT_EQ(cv::countNonZero(layer(kDarkLive).clone().reshape(1) != 0), 0);
}

TEST(LiveFaults, FollowsTheOneDefinitionWhereNothingIsMeasured) {
  cv::Mat grey(256, kPeriod_px, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v) grey.row(v).setTo(v);
  const cv::Mat layer = faults_layer(grey, FrameResult{});
  const Stripe dark = colour_in(layer, cv::Rect(0, 0, kPeriod_px, kTooDarkBelow)),
               bright = colour_in(layer, cv::Rect(0, kClippedFrom, kPeriod_px, 256 - kClippedFrom));
  ASSERT_NE(dark, kNothing);
  ASSERT_NE(bright, kNothing);
  for (int v = 0; v < grey.rows; ++v) {
    const Stripe row = colour_in(layer, cv::Rect(0, v, kPeriod_px, 1));
    EXPECT_EQ(row, v < kTooDarkBelow ? dark : v >= kClippedFrom ? bright : kNothing) << v;
  }
}

TEST(LiveFaults, AnImageWithoutAnyNeedsNoLayer) {
  EXPECT_TRUE(faults_layer(cv::Mat(40, 60, CV_8UC1, cv::Scalar(120)), FrameResult{}).empty());
}

TEST(LiveFocus, ShowsTheEdgesOfASharpImageAndNoneOfABlurredOne) {
  constexpr int kEdge = 50;
  cv::Mat sharp(80, 100, CV_8UC1, cv::Scalar(40)), blurred;
  sharp.colRange(kEdge, sharp.cols).setTo(140);
  cv::GaussianBlur(sharp, blurred, {}, 4);
  const cv::Mat layer = focus_layer(sharp, FrameResult{});
  for (int v = 0; v < layer.rows; ++v)
    for (int u = 0; u < layer.cols; ++u)
      ASSERT_EQ(layer.at<Stripe>(v, u) != kNothing, u == kEdge - 1 || u == kEdge) << u << ' ' << v;
  EXPECT_EQ(cv::countNonZero(focus_layer(blurred, FrameResult{}).reshape(1)), 0);
}

DepthMap map_of(const cv::Mat& depth_mm) {
  DepthMap map;
  map.depth_mm = depth_mm;
  return map;
}

TEST(DepthLayer, IsTheColoursOfTheDepthWhereThereIsAny) {
  constexpr double kTop_mm = 0.8;
  cv::Mat depth_mm(90, 700, CV_32FC1, cv::Scalar(0.01));
  depth_mm.row(3).setTo(std::numeric_limits<float>::quiet_NaN());
  depth_mm.row(50).colRange(610, 650).setTo(-5);  // a bulge beyond the scale
  for (int u = 290; u < 600; ++u)
    for (int v = 40; v < 70; ++v) depth_mm.at<float>(v, u) = 0.01F * static_cast<float>(u - 290);
  const PartLayer layer = depth_layer(map_of(depth_mm), kTop_mm);
  ASSERT_FALSE(layer.pixels.empty());
  EXPECT_LT(layer.pixels.total(), depth_mm.total() / 3) << "where nothing is";
  cv::Mat whole = cv::Mat::zeros(depth_mm.size(), CV_8UC4);
  layer.pixels.copyTo(whole(cv::Rect(layer.at, layer.pixels.size())));
  for (int v = 0; v < whole.rows; ++v)
    for (int u = 0; u < whole.cols; ++u) {
      const double depth = static_cast<double>(depth_mm.at<float>(v, u));
      const Stripe here = whole.at<Stripe>(v, u);
      if (!(std::abs(depth) > 0.05)) {
        EXPECT_EQ(here, kNothing) << u << ", " << v;
        continue;
      }
      // Full from 0.25 mm on, and 85 % of the colour then; of bulges the scale ends at a quarter.
      if (std::abs(depth - kTop_mm) < 0.01) continue;  // a step around the end of the scale
      const double part = std::clamp(depth / kTop_mm, -0.25, 1.0);
      const double alpha = 0.85 * std::min((std::abs(part * kTop_mm) - 0.05) / 0.2, 1.0);
      EXPECT_NEAR(here[3], 255 * alpha, 5) << u << ", " << v;
      const MapColour colour = depth < -0.25 * kTop_mm ? kBelowScale
                               : depth > kTop_mm       ? kAboveScale
                                                       : depth_colour(part);
      EXPECT_NEAR(here[0], alpha * colour.blue, 5);
      EXPECT_NEAR(here[1], alpha * colour.green, 5);
      EXPECT_NEAR(here[2], alpha * colour.red, 5);
    }
}

TEST(DepthLayer, OfAnUntouchedFaceIsNothing) {
  cv::Mat depth_mm(50, 70, CV_32FC1);
  cv::randu(depth_mm, -0.049, 0.049);
  EXPECT_TRUE(depth_layer(map_of(depth_mm), 1).pixels.empty());
}

}  // namespace
}  // namespace alltact
