// Cameras in files of their own, and how their lens was calibrated.
#include "core/finger/finger.h"
#include "tests/core/finger/finger_files.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::kFinRay;
using test::TemporaryFolder;
using testing::HasSubstr;

using OwnCameraFile = test::FingerFiles;

TEST_F(OwnCameraFile, CamerasHaveFilesOfTheirOwn) {
  const CameraParameters camera = load(kFinRay)->camera;
  const fs::path file = folder_ / "camera.yaml";
  ASSERT_TRUE(save_camera(file, camera).ok());
  EXPECT_EQ(load_camera(file)->parameters, camera);
  std::ofstream(file) << "camera:\n  model: pinhole\n  size: [64, 48]\n  fx: 50\n  fy: 0\n"
                         "  cx: 31.5\n  cy: 23.5\n";
  EXPECT_TRUE(load_camera(file).error().where.english().ends_with("camera.yaml:5: camera.fy"));
  std::ofstream(file) << "model: pinhole\nsize: [64, 48]\nfx: 50\nfy: 0\ncx: 31.5\ncy: 23.5\n";
  EXPECT_TRUE(load_camera(file).error().where.english().ends_with("camera.yaml:4: fy"));
  EXPECT_FALSE(save_camera(file, CameraParameters{}).ok());
  EXPECT_FALSE(load_camera(folder_ / "none.yaml").ok());
}

TEST_F(OwnCameraFile, HowTheLensWasCalibratedStaysWithTheCamera) {
  const TemporaryFolder folder;
  const LensRecord record{{"fx_sd_px", "0.12"}, {"verdict", "good: 0.02 mm, at 60 mm"}};
  CameraParameters camera;
  camera.width_px = 960, camera.height_px = 540;
  camera.fx_px = camera.fy_px = 523.9;
  camera.sd_px = {0.2, 0.25, 0.1, 0.15};
  ASSERT_TRUE(save_camera(folder / "camera.yaml", camera, record));
  const auto again = load_camera(folder / "camera.yaml");
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->parameters, camera);
  EXPECT_EQ(again->lens, record);
  EXPECT_EQ(again->understood.english(),
            "read as a camera file of this program: 960 x 540 px, fx 523.9, no distortion");

  std::string text = kFinRay;
  text.insert(text.find("face:"), "  lens: {fx_sd_px: 0.12, halves: [1, 2], verdict: good}\n");
  const auto finger = Finger::parse(text, "finger.yaml");
  ASSERT_TRUE(finger) << finger.error().sentence();
  EXPECT_EQ(finger->lens_record, (LensRecord{{"fx_sd_px", "0.12"}, {"verdict", "good"}}));
  const auto written = finger->to_yaml();
  ASSERT_TRUE(written);
  EXPECT_THAT(*written, HasSubstr("  lens: {fx_sd_px: 0.12, verdict: good, halves: [1, 2]}\n"));
}

TEST_F(OwnCameraFile, WhatIsNotKnownOfAWindowIsKept) {
  const std::string port =
      "  port: {gap_mm: 2.0, plate_mm: 3.0, plate_index: 1.49, medium_index: 1.41, glue: clear}\n";
  std::string text = kFinRay;
  text.insert(text.find("face:"), port);
  std::vector<Message> warnings;
  const auto finger = load(text, &warnings);
  ASSERT_TRUE(finger) << finger.error().sentence();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].english(), HasSubstr("camera.port.glue: is not known"));
  EXPECT_THAT(saved(*finger), HasSubstr(port));
}

}  // namespace
}  // namespace alltact
