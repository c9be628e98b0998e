// Skin that bulges, and depths at a limit: against painted and against rendered truth.
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/result_json.h"
#include "tests/core/simulation/scene_text.h"
#include "tests/support/flat_sensor.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test::bulge_reading {
namespace {

constexpr double kU = 150, kV = 117;

FramePtr frame_of(const cv::Mat& grey) {
  auto frame = std::make_shared<Frame>();
  frame->grey = grey;
  frame->name = "press";
  return frame;
}

FrameResult measured(const cv::Mat& untouched, const cv::Mat& pressed, const Finger& finger) {
  const FingerSnapshot snapshot = FingerSnapshot::of({}, finger).value();
  Pipeline pipeline = Pipeline::with_library(ReferenceLibrary::single(untouched).value(), snapshot,
                                             PipelineSettings{});
  auto result = pipeline(frame_of(pressed));
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

/// Errors of depth where the truth lies within a range.
struct Errors {
  double mean_mm = 0, rms_mm = 0;
  int pixels = 0;
};
Errors errors_where(const cv::Mat& depth_mm, const cv::Mat& truth_mm, double from, double to) {
  Errors errors;
  double square = 0;
  for (int v = 0; v < depth_mm.rows; ++v)
    for (int u = 0; u < depth_mm.cols; ++u) {
      const auto truth = static_cast<double>(truth_mm.at<float>(v, u));
      const auto read = static_cast<double>(depth_mm.at<float>(v, u));
      if (!(truth >= from && truth <= to) || !std::isfinite(read)) continue;
      errors.mean_mm += read - truth;
      square += (read - truth) * (read - truth);
      ++errors.pixels;
    }
  errors.mean_mm /= errors.pixels;
  errors.rms_mm = std::sqrt(square / errors.pixels);
  return errors;
}

/// A ball 0.5 mm deep with a ring around it that rises by height_mm, 1.2 mm wide.
cv::Mat_<float> ball_in_a_ring(double height_mm) {
  cv::Mat_<float> depth = ball_depth_mm(kU, kV, 0.5);
  const double rim_mm = std::sqrt(0.5 * (2 * FlatSensor::kBallRadiusMm - 0.5));
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double part = (FlatSensor::kMmPerPx * std::hypot(u - kU, v - kV) - rim_mm) / 1.2;
      if (part > 0 && part < 1)
        depth(v, u) -=
            static_cast<float>(height_mm * std::pow(std::sin(part * std::numbers::pi), 2));
    }
  return depth;
}

TEST(BulgeReading, APaintedBulgeIsReadAsHighAsItIs) {
  for (const double height_mm : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    const cv::Mat_<float> truth = ball_in_a_ring(height_mm);
    const FrameResult result =
        measured(untouched_picture(1), pressed_picture(truth, 2), flat_sensor_finger(true));
    ASSERT_TRUE(result.depth);
    const Errors top = errors_where(result.depth->depth_mm, truth, -height_mm, -0.9 * height_mm);
    EXPECT_GT(top.pixels, 300);
    EXPECT_LT(std::abs(top.mean_mm), 0.005 + 0.03 * height_mm) << height_mm;
    // A bulge is no contact, and takes nothing off the one that it surrounds.
    ASSERT_EQ(result.regions.size(), 1U) << height_mm;
    EXPECT_NEAR(result.regions[0].deepest_mm, 0.5, 0.03) << height_mm;
    EXPECT_EQ(result.regions[0].limits, kNoLimit);
  }
}

TEST(BulgeReading, OfUntouchedSkinNoiseHasNoBias) {
  int regions = 0;
  double mean_mm = 0;
  constexpr int kPictures = 40;
  for (int i = 0; i < kPictures; ++i) {
    const FrameResult result = measured(untouched_picture(100 + 2 * i),
                                        untouched_picture(101 + 2 * i), flat_sensor_finger(true));
    mean_mm +=
        cv::mean(result.depth->depth_mm, result.depth->depth_mm == result.depth->depth_mm)[0];
    regions += static_cast<int>(result.regions.size());
  }
  EXPECT_LT(std::abs(mean_mm / kPictures), 5e-4);
  EXPECT_EQ(regions, 0);
}

TEST(BulgeReading, DepthAtTheLayersLimitIsMarkedEverywhere) {
  Finger finger = flat_sensor_finger(true);
  finger.face.layer_mm = 0.4;  // thinner than it was pressed
  const FrameResult result =
      measured(untouched_picture(1), pressed_picture(ball_depth_mm(kU, kV, 0.6), 2), finger);
  ASSERT_EQ(result.regions.size(), 1U);
  EXPECT_NEAR(result.regions[0].deepest_mm, 0.4, 1e-6);
  EXPECT_NE(result.regions[0].limits & kLayerLimit, 0);
  EXPECT_THAT(result_line(result, 0, ReferenceMethod::kLocal),
              testing::HasSubstr("\"limits\":[\"layer_limit\""));
  const Mapping mapping = Mapping::create(*finger.mapping).value();
  const DepthSdAndLimits made =
      depth_sd_and_limits(*result.depth, *result.reference, *result.shape, mapping);
  int cut = 0;
  for (int v = 0; v < made.limits.rows; ++v)
    for (int u = 0; u < made.limits.cols; ++u) {
      const bool is_cut = result.depth->depth_mm.at<float>(v, u) >= 0.4F;
      EXPECT_EQ(is_cut, (made.limits.at<std::uint8_t>(v, u) & kLayerLimit) != 0);
      cut += is_cut ? 1 : 0;
    }
  EXPECT_GT(cut, 300);
}

TEST(BulgeReading, BulgesAreBoundedByTheLayerAndMarked) {
  Finger finger = flat_sensor_finger(true);
  finger.face.layer_mm = 0.15;
  const cv::Mat_<float> truth = ball_in_a_ring(0.4);
  const FrameResult result = measured(untouched_picture(1), pressed_picture(truth, 2), finger);
  int marked = 0;
  for (int v = 0; v < truth.rows; ++v)
    for (int u = 0; u < truth.cols; ++u) {
      const float depth = result.depth->depth_mm.at<float>(v, u);
      if (!std::isfinite(depth)) continue;
      ASSERT_GE(depth, -0.15F);
      if (depth == -0.15F) {
        EXPECT_EQ(result.depth->flags.at<std::uint8_t>(v, u), kBulgeLimit);
        ++marked;
      }
    }
  EXPECT_GT(marked, 500);
}

/// `alltact simulate`: a ball in a layer that keeps its volume, light that is local.
Plan bulge_plan(const std::string& pressed, std::uint64_t seed) {
  return plan_of(
      "name: bulge\nwhy: to test with\nframes: 1\nfinger:\n"
      "  camera: {model: orthographic, size: [480, 360], mm_per_px: 0.05, cx: 239.5, cy: 179.5}\n"
      "  face: {kind: flat, layer_mm: 1.5, plane_z_mm: 30.0}\neffects:\n" +
          pressed +
          "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
          "  - use: leds\n    lamps:\n"
          "      - {at_mm: [-20.0, 0.0, 0.0], power: 200000.0}\n"
          "      - {at_mm: [20.0, 0.0, 0.0], power: 200000.0}\n"
          "  - {use: read, sd: 1.0}\n  - {use: quantisation}\n",
      seed);
}

TEST(BulgeReading, ATenthOfAMillimetreOnSimulatedSkinIsReadWithinAFiftieth) {
  const cv::Mat untouched = bulge_plan("", 1).render(0);
  const Plan plan = bulge_plan(
      "  - {use: ball, radius_mm: 4.0, s_mm: 0.0, y_mm: 0.0, depth_mm: 0.9}\n"
      "  - {use: bulge, share: 0.0667, width_mm: 1.5}\n",
      2);
  const cv::Mat pressed = plan.render(0), truth = plan.truth(0).depth_mm;
  Finger finger = flat_sensor_finger(false);
  finger.camera.width_px = 480, finger.camera.height_px = 360;
  finger.camera.cx_px = 239.5, finger.camera.cy_px = 179.5, finger.camera.mm_per_px = 0.05;
  finger.face.layer_mm = 1.5, finger.face.plane_z_mm = 30;
  finger.mapping.emplace();
  finger.mapping->kind = MappingKind::kMoebius;
  finger.mapping->along = MappingAlong::kNormal;
  finger.mapping->x_max = 0.8;
  finger.mapping->a_mm = 1.5 * (1 + 0.6 * 1.5), finger.mapping->b = 0.6 * 1.5;
  const FrameResult result = measured(untouched, pressed, finger);
  ASSERT_TRUE(result.depth);
  double least = 0;
  cv::minMaxLoc(truth, &least, nullptr);
  ASSERT_NEAR(least, -0.1, 0.002);
  const Errors top = errors_where(result.depth->depth_mm, truth, -0.2, -0.09);
  EXPECT_GT(top.pixels, 1000);
  EXPECT_LT(std::abs(top.mean_mm), 0.02);
  const Errors press = errors_where(result.depth->depth_mm, truth, 0.1, 2);
  EXPECT_LT(std::abs(press.mean_mm), 0.02);
  RecordProperty("bulge_mean_off_mm", fmt::format("{:.4f}", top.mean_mm));
  RecordProperty("bulge_rms_mm", fmt::format("{:.4f}", top.rms_mm));
}

}  // namespace
}  // namespace alltact::test::bulge_reading
