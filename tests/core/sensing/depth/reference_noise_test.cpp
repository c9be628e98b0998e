// The noise that is told of a flat sensor's picture, against what was added to it.
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kSensorWidth = 320, kSensorHeight = 240;
const double kQuantisation = std::sqrt(1.0 / 12.0);

Finger flat_finger_of_noise(bool is_calibrated) {
  Finger finger;
  finger.name = "flat";
  finger.camera.model = CameraModel::kOrthographic;
  finger.camera.width_px = kSensorWidth, finger.camera.height_px = kSensorHeight;
  finger.camera.cx_px = 159.5, finger.camera.cy_px = 119.5;
  finger.camera.mm_per_px = 0.06;
  finger.face.kind = FaceKind::kFlat;
  finger.face.layer_mm = 3.0;
  finger.face.plane_z_mm = 20;
  if (!is_calibrated) return finger;
  finger.mapping.emplace();
  finger.mapping->kind = MappingKind::kMoebius;
  finger.mapping->x_max = 0.5;
  finger.mapping->a_mm = 2.2, finger.mapping->b = 1.5;
  return finger;
}

FaceRuns whole_plane() {
  const Finger finger = flat_finger_of_noise(false);
  const FaceShape shape = FaceShape::plane(Camera::create(finger.camera).value(), finger.face);
  return face_runs(shape, 1.0, {kSensorWidth, kSensorHeight});
}

/// A face that is brightest in the middle, with lines printed on it; pressed by a ball.
double level_at(int u, int v, bool is_pressed) {
  const double s = (u - 150.0) / kSensorWidth, t = (v - 130.0) / kSensorHeight;
  const double printed = u % 9 == 0 || (u + 2 * v) % 23 < 2 ? 0.85 : 1.0;
  const double r = std::hypot(u - 90.0, v - 100.0) / 45.0;
  const double dent = is_pressed && r < 1.0 ? 1.0 - 0.3 * (1.0 - r * r) : 1.0;
  return printed * dent * 150.0 * (1.0 - 0.8 * (s * s + t * t));
}

cv::Mat noisy_picture(double sigma, bool is_pressed, std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, sigma);
  cv::Mat image(kSensorHeight, kSensorWidth, CV_8UC1);
  for (int v = 0; v < kSensorHeight; ++v)
    for (int u = 0; u < kSensorWidth; ++u)
      image.at<std::uint8_t>(v, u) =
          cv::saturate_cast<std::uint8_t>(level_at(u, v, is_pressed) + noise(random));
  return image;
}

ReferenceImage as_reference(const cv::Mat& grey) {
  cv::Mat levels;
  grey.convertTo(levels, CV_32F);
  return ReferenceImage(levels);
}

TEST(ReferenceNoise, IsWhatWasAddedWhateverIsPrintedOnTheSkin) {
  const FaceRuns face = whole_plane();
  for (const double sigma : {0.5, 0.7, 1.0, 1.6, 2.5, 4.0, 8.0}) {
    const double truth = std::hypot(sigma, kQuantisation);
    for (unsigned seed = 1; seed <= 12; ++seed) {
      std::mt19937_64 random(seed);
      const cv::Mat untouched = noisy_picture(sigma, false, random),
                    live = noisy_picture(sigma, true, random);
      const auto told = noise_against_reference(live, as_reference(untouched), 1.0, face);
      ASSERT_TRUE(told);
      EXPECT_NEAR(*told / truth, 1.0, 0.1) << sigma << ", seed " << seed;
    }
  }
}

TEST(ReferenceNoise, OfAReferenceWithoutNoiseIsAllThePictures) {
  const FaceRuns face = whole_plane();
  std::mt19937_64 random(5);
  cv::Mat exact(kSensorHeight, kSensorWidth, CV_32FC1);
  for (int v = 0; v < kSensorHeight; ++v)
    for (int u = 0; u < kSensorWidth; ++u)
      exact.at<float>(v, u) = static_cast<float>(level_at(u, v, false));
  const auto told =
      noise_against_reference(noisy_picture(1.5, true, random), ReferenceImage(exact), 0.0, face);
  ASSERT_TRUE(told);
  EXPECT_NEAR(*told / std::hypot(1.5, kQuantisation), 1.0, 0.1);
}

TEST(ReferenceNoise, IsNeverLessThanQuantisationAndNotToldOfWhatCannotBeMeasured) {
  const FaceRuns face = whole_plane();
  std::mt19937_64 random(6);
  const cv::Mat image = noisy_picture(1.0, false, random);
  EXPECT_DOUBLE_EQ(noise_against_reference(image, as_reference(image), 1.0, face).value(),
                   kQuantisation);
  const cv::Mat black(kSensorHeight, kSensorWidth, CV_8UC1, cv::Scalar(3)),
      white(kSensorHeight, kSensorWidth, CV_8UC1, cv::Scalar(255));
  EXPECT_FALSE(noise_against_reference(image, as_reference(black), 1.0, face));
  EXPECT_FALSE(noise_against_reference(image, as_reference(white), 1.0, face));
  EXPECT_FALSE(noise_against_reference(white, as_reference(image), 1.0, face));
  EXPECT_FALSE(noise_against_reference(image, as_reference(image), 1.0, FaceRuns{{}, {0}}));
}

/// What the pipeline says of depths and differences: whatever the light is taken to be, and without
/// a change of depth.
class FlatNoise : public testing::TestWithParam<bool> {};

TEST_P(FlatNoise, IsMeasuredByThePipelineAndMovesNoDepth) {
  PipelineSettings settings;
  settings.correct_light = GetParam();
  const Mapping mapping = Mapping::create(*flat_finger_of_noise(true).mapping).value();
  for (const double sigma : {0.5, 1.0, 2.5}) {
    const double truth = std::hypot(sigma, kQuantisation);
    std::vector<double> ratios;
    for (unsigned seed = 1; seed <= 5; ++seed) {
      std::mt19937_64 random(100 + seed);
      const cv::Mat untouched = noisy_picture(sigma, false, random);
      auto frame = std::make_shared<Frame>();
      frame->grey = noisy_picture(sigma, true, random);
      frame->name = "press";
      const auto result_of = [&](bool is_calibrated) {
        return Pipeline::with_library(
                   ReferenceLibrary::single(untouched).value(),
                   FingerSnapshot::of({}, flat_finger_of_noise(is_calibrated)).value(),
                   settings)(frame)
            .value();
      };
      const FrameResult bare = result_of(false), measured = result_of(true);
      ASSERT_TRUE(bare.difference && measured.depth);
      const Smoothing plain = gaussian_smoothing(settings.smoothing_px),
                      smoothing = smoothing_of(settings.smoothing_px);
      ratios.push_back(bare.difference->grey_sd / (std::sqrt(2.0) * plain.noise_factor() * truth));
      ratios.push_back(measured.depth->live_sd / (smoothing.noise_factor() * truth));

      DifferenceOptions as_before;  // one grey level
      as_before.smoothing = smoothing;
      as_before.correct_light = GetParam();
      const DepthMap before =
          depth_map(measured.grey, *measured.reference, *measured.shape, as_before, mapping);
      EXPECT_EQ(cv::countNonZero(before.flags != measured.depth->flags), 0);
      for (int v = 0; v < kSensorHeight; ++v)
        for (int u = 0; u < kSensorWidth; ++u) {
          const float a = before.depth_mm.at<float>(v, u),
                      b = measured.depth->depth_mm.at<float>(v, u);
          ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << u << ", " << v;
        }
    }
    std::sort(ratios.begin(), ratios.end());
    EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, 0.1) << sigma;
    EXPECT_GT(ratios.front(), 0.9) << sigma;
    // Against the reference the printed skin may look a little noisier where light is corrected.
    EXPECT_LT(ratios.back(), 1.2) << sigma;
  }
}

INSTANTIATE_TEST_SUITE_P(Light, FlatNoise, testing::Bool());

}  // namespace
}  // namespace alltact
