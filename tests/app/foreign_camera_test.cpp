// `alltact new` with camera files of other programs.
#include "core/finger/finger.h"
#include "tests/support/flat_finger.h"
#include "tests/support/foreign_cameras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;

TEST(ForeignCameraFile, MakesAFingerAndSaysWhatWasUnderstood) {
  const TemporaryFolder folder;
  const ForeignCamera camera = some_foreign_camera();
  int number = 0;
  for (const ForeignFile& file : foreign_files(camera)) {
    write_text(folder / file.name, file.text);
    const std::string finger = (folder / fmt::format("finger_{}", ++number)).string();
    const ProgramRun run = make_fin_ray(finger, folder / file.name);
    ASSERT_EQ(run.status, 0) << file.name << "\n" << run.errors;
    const std::size_t bar = file.understood.find('|');
    EXPECT_THAT(run.output,
                HasSubstr("Camera " + file.understood.substr(0, bar) +
                          ": 960 x 540 px, fx 523.9, " + file.understood.substr(bar + 1) + "\n"));
    EXPECT_EQ(run.errors, "") << file.name;
    const auto made = Finger::load(finger);
    ASSERT_TRUE(made) << made.error().sentence();
    ASSERT_EQ(made->camera.distortion.size(), camera.terms.size()) << file.name;
    for (std::size_t k = 0; k < camera.terms.size(); ++k)
      EXPECT_DOUBLE_EQ(made->camera.distortion[k], camera.terms[k]) << file.name;
  }
}

TEST(ForeignCameraFile, WhatWasExportedMakesTheSameFinger) {
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: brown\nsize: [640, 480]\nfx: 411.5\nfy: 412.25\ncx: 320.5\ncy: 239.75\n"
             "distortion: [-0.11, 0.02, 0.001, -0.002, 0.0, 0.01]\norientation: flip_u\n");
  const std::string finger = (folder / "finger").string(), out = (folder / "out").string();
  ASSERT_EQ(make_fin_ray(finger, folder / "camera.yaml").status, 0);
  ASSERT_EQ(run_alltact({"export", finger, "--to", "opencv,ros,json", "-o", out}).status, 0);
  const auto before = Finger::load(finger);
  ASSERT_TRUE(before);
  for (const char* name : {"camera.opencv.yaml", "camera_info.yaml", "calibration.json"}) {
    const std::string again = (folder / (std::string("again_") + name)).string();
    const ProgramRun run = make_fin_ray(again, folder / "out" / name);
    ASSERT_EQ(run.status, 0) << run.errors;
    auto made = Finger::load(again);
    ASSERT_TRUE(made);
    made->camera.distortion.resize(6);
    EXPECT_EQ(made->camera, before->camera) << name;
  }
  const ProgramRun parameters =
      make_fin_ray((folder / "none").string(), folder / "out/parameters.yaml");
  EXPECT_EQ(parameters.status, 1);
}

TEST(ForeignCameraFile, WarnsOfAGuessAndOfKeysThatWereNotRead) {
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: pinhole\nsize: [640, 480]\nfx: 411.5\nfy: 412.25\n"
             "cx: 320.5\ncy: 239.75\nserial: 12\n");
  const ProgramRun run = make_fin_ray((folder / "finger").string(), folder / "camera.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.errors, HasSubstr("Warning: "));
  EXPECT_THAT(run.errors, HasSubstr("keys that are not known here were not read: serial.\n"));
}

TEST(ForeignCameraFile, AnImageOfAnotherSizeIsNotScaled) {
  const FlatFinger flat;
  const std::filesystem::path camera = flat.file("ros.yaml");
  write_text(camera, foreign_files(some_foreign_camera()).front().text);
  const std::string finger = flat.file("half");
  ASSERT_EQ(run_alltact({"new", finger, "--camera", camera.string(), "--kind", "flat", "--layer-mm",
                         "3", "--plane-z-mm", "40"})
                .status,
            0);
  const std::filesystem::path image = flat.file("half.png");
  cv::imwrite(image.string(), cv::Mat(270, 480, CV_8UC1, cv::Scalar(90)));
  const ProgramRun run = run_alltact({"calibrate", finger, image.string(), "--reference",
                                      image.string(), "--ball-radius-mm", "4"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("480 x 270 px"));
  EXPECT_THAT(run.errors, HasSubstr("960 x 540"));
}

}  // namespace
}  // namespace alltact::test
