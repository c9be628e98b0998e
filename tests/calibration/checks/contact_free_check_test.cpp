// The light of a flat sensor changed by known amounts.
#include "calibration/checks/contact_free_check.h"

#include "core/image/image_file.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/temporary_folder.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::FlatSensor;

class AgedSensor : public testing::Test {
 protected:
  AgedSensor() {
    finger_.name = "aged";
    finger_.camera.model = CameraModel::kOrthographic;
    finger_.camera.width_px = FlatSensor::kWidth, finger_.camera.height_px = FlatSensor::kHeight;
    finger_.camera.cx_px = 0.5 * FlatSensor::kWidth,
    finger_.camera.cy_px = 0.5 * FlatSensor::kHeight;
    finger_.camera.mm_per_px = FlatSensor::kMmPerPx;
    finger_.face.kind = FaceKind::kFlat;
    finger_.face.layer_mm = FlatSensor::kLayerMm;
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.x_max = 0.5, mapping.a_mm = FlatSensor::kA, mapping.b = FlatSensor::kB;
    finger_.mapping = mapping;
    finger_.reference = ReferenceFiles{"", "", "ref.png"};
    EXPECT_TRUE(write_image(folder_ / "ref.png", test::untouched_picture(1)).ok());
  }

  /// light: what the brightness at a place (-1 to 1 both ways) is multiplied with.
  ContactFreeCheck check(const std::function<double(double, double)>& light) {
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < 3; ++i) {
      cv::Mat image = test::untouched_picture(static_cast<std::uint64_t>(10 + i));
      for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u)
          image.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(
              image.at<std::uint8_t>(v, u) *
              light(2.0 * u / image.cols - 1.0, 2.0 * v / image.rows - 1.0));
      files.push_back(folder_ / ("now_" + std::to_string(i) + ".png"));
      EXPECT_TRUE(write_image(files.back(), image).ok());
    }
    const auto result =
        check_contact_free(FingerSnapshot::of(folder_.path(), finger_).value(), files, Job());
    EXPECT_TRUE(result.ok()) << result.error().sentence();
    return result.value();
  }

  test::TemporaryFolder folder_;
  Finger finger_;
};

TEST_F(AgedSensor, SameLightPasses) {
  const ContactFreeCheck same = check([](double, double) { return 1.0; });
  EXPECT_EQ(same.verdict, CheckVerdict::kPass) << same.sentence.english();
  EXPECT_NEAR(same.light_change, 0.0, 0.002);
  EXPECT_LT(same.false_depth_mm, same.limit_mm);
  EXPECT_EQ(same.image_count, 3);
}

TEST_F(AgedSensor, AFewPercentDriftAndAreTakenOut) {
  const ContactFreeCheck darker =
      check([](double s, double t) { return 0.965 * (1.0 + 0.01 * s - 0.006 * t * t); });
  EXPECT_EQ(darker.verdict, CheckVerdict::kDrifting) << darker.sentence.english();
  EXPECT_NEAR(darker.light_change, -0.035, 0.003);
  // 3.5 % are 0.077 mm of a mapping that begins with 2.2 mm.
  EXPECT_NEAR(darker.uncorrected_mm, 0.035 * FlatSensor::kA, 0.05);
  EXPECT_LT(darker.false_depth_mm, darker.limit_mm);
  EXPECT_THAT(darker.sentence.english(), testing::HasSubstr("3.5 % darker"));
}

TEST_F(AgedSensor, MuchMoreOrAStainWantsANewReference) {
  EXPECT_EQ(check([](double, double) { return 0.9; }).verdict, CheckVerdict::kRecalibrate);
  const ContactFreeCheck stained = check([](double s, double t) {
    return s * s + t * t < 0.3 ? 0.94 : 1.0;  // a dull patch in the middle
  });
  EXPECT_EQ(stained.verdict, CheckVerdict::kRecalibrate) << stained.sentence.english();
  EXPECT_THAT(stained.sentence.english(), testing::HasSubstr("record the reference again"));
}

TEST_F(AgedSensor, WhatCannotBeCheckedIsSaid) {
  Finger bare = finger_;
  bare.mapping.reset();
  EXPECT_FALSE(check_contact_free(FingerSnapshot::of(folder_.path(), bare).value(),
                                  {folder_ / "ref.png"}, Job())
                   .ok());
  EXPECT_FALSE(check_contact_free(FingerSnapshot::of(folder_.path(), finger_).value(),
                                  {folder_ / "absent.png"}, Job())
                   .ok());
}

}  // namespace
}  // namespace alltact
