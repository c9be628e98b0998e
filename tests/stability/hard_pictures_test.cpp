// Pictures that no finger gives in good order, through the whole pipeline: each is measured within
// a bound, or a problem says by name why not, and no number leaves it that is none.
#include "core/sensing/pipeline.h"
#include "tests/stability/awaited.h"
#include "tests/support/flat_sensor.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::FlatSensor;
using testing::AnyOf;
using testing::HasSubstr;

/// d = a x / (1 + b x), turned round.
double difference_of(double depth_mm) {
  return depth_mm / (FlatSensor::kA - FlatSensor::kB * depth_mm);
}

class HardPictures : public testing::Test {
 protected:
  FrameResult measured(const cv::Mat& grey) {
    auto frame = std::make_shared<Frame>();
    frame->grey = grey;
    frame->name = "frame";
    auto result = pipeline_(frame);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().sentence());
    expect_no_false_numbers(*result);
    return *result;
  }

  /// Measured means finite; what is not finite says why.
  static void expect_no_false_numbers(const FrameResult& result) {
    if (!result.depth) return;
    const DepthMap& map = *result.depth;
    for (int v = 0; v < map.flags.rows; ++v)
      for (int u = 0; u < map.flags.cols; ++u)
        if (map.flags.at<std::uint8_t>(v, u) == kMeasured) {
          const float depth = map.depth_mm.at<float>(v, u);
          ASSERT_LE(std::abs(depth), FlatSensor::kLayerMm) << u << ", " << v << ": " << depth;
        }
    EXPECT_TRUE(std::isfinite(map.noise_mm) && std::isfinite(map.live_sd));
    for (const ContactRegion& region : result.regions)
      EXPECT_TRUE(region.position_mm.allFinite() && std::isfinite(region.volume_mm3) &&
                  std::isfinite(region.deepest_mm) && std::isfinite(region.area_mm2));
  }

  static std::string problems(const FrameResult& result) {
    return fmt::format("{}", fmt::join(result.problems, "; "));
  }

  Pipeline pipeline_ = Pipeline::with_library(
      ReferenceLibrary::single(test::untouched_picture(1)).value(),
      FingerSnapshot::of({}, test::flat_sensor_finger(true)).value(), PipelineSettings{});
};

double part_measured(const DepthMap& map) {
  return cv::countNonZero(map.flags == kMeasured) / static_cast<double>(map.flags.total());
}

/// Of the measured pixels where `mask` is set.
double mean_error_mm(const DepthMap& map, const cv::Mat_<float>& truth, const cv::Mat& mask) {
  double sum = 0;
  int count = 0;
  for (int v = 0; v < truth.rows; ++v)
    for (int u = 0; u < truth.cols; ++u)
      if (mask.at<std::uint8_t>(v, u) != 0 && map.flags.at<std::uint8_t>(v, u) == kMeasured) {
        sum += std::abs(static_cast<double>(map.depth_mm.at<float>(v, u) - truth(v, u)));
        ++count;
      }
  return count > 0 ? sum / count : INFINITY;
}

TEST_F(HardPictures, AnUntouchedOneHasNoContact) {
  ALLTACT_SKIP_IF_AWAITED();
  const FrameResult result = measured(test::untouched_picture(5));
  ASSERT_TRUE(result.depth);
  EXPECT_GT(part_measured(*result.depth), 0.99);
  EXPECT_TRUE(result.regions.empty());
  EXPECT_EQ(problems(result), "");
}

TEST_F(HardPictures, ABlackOneIsNamed) {
  ALLTACT_SKIP_IF_AWAITED();
  const FrameResult result =
      measured(cv::Mat(FlatSensor::kHeight, FlatSensor::kWidth, CV_8UC1, cv::Scalar(3)));
  EXPECT_THAT(problems(result), AnyOf(HasSubstr("dark"), HasSubstr("black")));
  EXPECT_TRUE(result.regions.empty());
}

TEST_F(HardPictures, AConstantOneIsNamed) {
  ALLTACT_SKIP_IF_AWAITED();
  const FrameResult result =
      measured(cv::Mat(FlatSensor::kHeight, FlatSensor::kWidth, CV_8UC1, cv::Scalar(120)));
  EXPECT_NE(problems(result), "");
}

TEST_F(HardPictures, OneThatIsSaturatedInAThirdIsNamedAndMeasuredInTheRest) {
  ALLTACT_SKIP_IF_AWAITED();
  const cv::Mat_<float> depth = test::ball_depth_mm(240, 120, 0.5);
  cv::Mat grey = test::pressed_picture(depth, 6);
  grey.colRange(0, FlatSensor::kWidth * 3 / 10).setTo(255);
  const FrameResult result = measured(grey);
  ASSERT_TRUE(result.depth);
  EXPECT_NEAR(part_measured(*result.depth), 0.7, 0.03);
  EXPECT_LT(mean_error_mm(*result.depth, depth, depth > 0.05F), 0.03);
  EXPECT_EQ(result.regions.size(), 1U);
  EXPECT_THAT(problems(result),
              AnyOf(HasSubstr("bright"), HasSubstr("saturated"), HasSubstr("overexposed")));
}

TEST_F(HardPictures, TheSameOneTwiceIsNamedAsFrozen) {
  ALLTACT_SKIP_IF_AWAITED();
  // A camera's noise never repeats: two pictures of the same bytes are one picture.
  const cv::Mat grey = test::untouched_picture(7);
  static_cast<void>(measured(grey));
  const FrameResult again = measured(grey.clone());
  EXPECT_THAT(problems(again), AnyOf(HasSubstr("same"), HasSubstr("frozen")));
}

TEST_F(HardPictures, OneThatIsReadAgainIsNotTakenForFrozen) {
  ALLTACT_SKIP_IF_AWAITED();
  // A recording's frame that is looked at twice is read from the file twice.
  Frame read;
  read.grey = test::untouched_picture(12);
  read.name = "frame_00007", read.origin = "recording.mkv", read.sequence = 7;
  Frame again = read;
  again.grey = read.grey.clone();
  static_cast<void>(pipeline_(std::make_shared<Frame>(read)));
  EXPECT_EQ(problems(*pipeline_(std::make_shared<Frame>(again))), "");
  again.grey = again.grey.clone();
  again.name = "frame_00008", again.sequence = 8;
  EXPECT_THAT(problems(*pipeline_(std::make_shared<Frame>(again))), HasSubstr("frozen"));
}

TEST_F(HardPictures, AContactOverFourFifthsOfTheFaceIsMeasured) {
  ALLTACT_SKIP_IF_AWAITED();
  cv::Mat_<float> depth(FlatSensor::kHeight, FlatSensor::kWidth, 0.0F);
  depth(cv::Rect(0, 0, FlatSensor::kWidth * 8 / 10, FlatSensor::kHeight)) = 0.4F;
  const FrameResult result = measured(test::pressed_picture(depth, 8));
  ASSERT_TRUE(result.depth);
  EXPECT_LT(mean_error_mm(*result.depth, depth, depth > 0.05F), 0.03);
  EXPECT_LT(mean_error_mm(*result.depth, depth, depth < 0.05F), 0.03);
  EXPECT_EQ(result.regions.size(), 1U);
}

TEST_F(HardPictures, ContactsThatTouchKeepTheirDepthsAndVolume) {
  ALLTACT_SKIP_IF_AWAITED();
  // Two balls 0.5 mm deep: contacts of 1.94 mm radius, 32 px; 63 px apart they overlap by a hair.
  const cv::Mat_<float> depth =
      cv::max(test::ball_depth_mm(128, 120, 0.5), test::ball_depth_mm(191, 120, 0.5));
  const FrameResult result = measured(test::pressed_picture(depth, 9));
  ASSERT_TRUE(result.depth);
  EXPECT_LT(mean_error_mm(*result.depth, depth, depth > 0.05F), 0.03);
  ASSERT_GE(result.regions.size(), 1U);
  ASSERT_LE(result.regions.size(), 2U);
  double volume = 0, truth = 0;
  for (const ContactRegion& region : result.regions) volume += region.volume_mm3;
  for (const float d : depth) truth += static_cast<double>(d) * std::pow(FlatSensor::kMmPerPx, 2);
  EXPECT_NEAR(volume / truth, 1, 0.08);
  if (result.regions.size() == 2) {
    const double left =
        std::min(result.regions[0].position_px.x(), result.regions[1].position_px.x());
    const double right =
        std::max(result.regions[0].position_px.x(), result.regions[1].position_px.x());
    EXPECT_NEAR(left, 128, 3);
    EXPECT_NEAR(right, 191, 3);
  } else {
    EXPECT_NEAR(result.regions[0].position_px.x(), 159.5, 2);
  }
}

TEST_F(HardPictures, NoneGivesADepthBeyondTheLayer) {
  ALLTACT_SKIP_IF_AWAITED();
  // Grey levels at random, whole stripes of 0 and of 255: expect_no_false_numbers() is the test.
  std::mt19937 random(10);
  cv::Mat grey = test::untouched_picture(11);
  for (int trial = 0; trial < 5; ++trial) {
    for (int v = 0; v < grey.rows; ++v)
      for (int u = 0; u < grey.cols; ++u)
        grey.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(random() >> (trial % 3));
    grey.rowRange(20, 40).setTo(0);
    grey.rowRange(60, 80).setTo(255);
    static_cast<void>(measured(grey));
  }
}

TEST_F(HardPictures, ADepthIsTheOneThatTheMappingWasMadeFrom) {
  ALLTACT_SKIP_IF_AWAITED();
  // The mapping of this file, as a check of the check: x of every depth and back.
  const Mapping mapping = Mapping::create(*test::flat_sensor_finger(true).mapping).value();
  for (const double depth_mm : {0.01, 0.1, 0.5})
    EXPECT_NEAR(mapping.depth_mm(difference_of(depth_mm)), depth_mm, 1e-12);
}

}  // namespace
}  // namespace alltact
