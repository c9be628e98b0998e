// What lies on disk after a run: everything that was promised, whole, and nothing else.
#include "core/image/image_file.h"
#include "tests/support/flat_finger.h"
#include "tests/support/small_disk.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <unistd.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& [name, content] : contents_of(folder)) names.push_back(name);
  return names;
}

TEST(Files, ACalibrationLeavesWhatTheDesignNames) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  EXPECT_THAT(names_in(flat.finger()), testing::ElementsAre("finger.yaml"));
  const ProgramRun run = flat.calibrate();
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(
      names_in(flat.finger()),
      testing::UnorderedElementsAre(
          "calibration.yaml", "calibration_inputs.yaml", "calibration_report.html",
          "calibration_report.json", "calibration_report.pdf", "finger.yaml", "presses/press_0.png",
          "presses/press_1.png", "presses/press_2.png", "presses/press_3.png", "reference.png"));
  // All four presses lie in the middle.
  EXPECT_THAT(run.output, HasSubstr("Verdict: unproven"));
  EXPECT_THAT(run.output, HasSubstr("no press in these thirds: left, right; press once in each"));
  EXPECT_EQ(run_alltact({"check", flat.finger()}).status, 0);
}

/// Puts these words into a picture, as a recorded one has them.
void take_with(const fs::path& image, const std::string& settings) {
  const auto grey = read_grey_image(image);
  ASSERT_TRUE(grey.ok());
  ASSERT_TRUE(write_image(image, *grey, settings).ok());
}

TEST(Files, WhatPressesWereTakenWithIsKeptAndHeldAgainstTheReference) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  EXPECT_EQ(flat.calibrate().errors, "");
  const fs::path yaml = flat.folder / "finger/finger.yaml";
  EXPECT_THAT(text_of(yaml), Not(HasSubstr("settings")));
  for (const fs::path& press : flat.presses) take_with(press, "Camera=usb-1; Gain=5");
  take_with(flat.file("ref.png"), "Camera=usb-1; Gain=3");
  const ProgramRun other = flat.calibrate();
  EXPECT_EQ(other.status, 0);
  EXPECT_THAT(other.errors, HasSubstr("Warning: The presses and the reference were taken with "
                                      "different settings: Gain changed from 3 to 5. "));
  EXPECT_THAT(text_of(yaml), HasSubstr("reference_settings: \"Camera=usb-1; Gain=3\"\n"));
  EXPECT_THAT(text_of(yaml), HasSubstr("press_settings: \"Camera=usb-1; Gain=5\"\n"));
  // The same presses as they are kept with the finger, against a reference like them.
  take_with(flat.file("ref.png"), "Camera=usb-1; Gain=5");
  EXPECT_EQ(flat.calibrate({flat.finger() + "/presses"}).errors, "");
  take_with(flat.presses[1], "Camera=usb-1; Gain=6");
  EXPECT_THAT(
      flat.calibrate().errors,
      HasSubstr("taken with changing settings of camera or light: Gain changed from 5 to 6."));
}

TEST(Files, AReconstructionMeasuresWhatWasPressed) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const cv::Mat truth = ball_depth_mm(170, 110, 0.45);
  cv::imwrite(flat.file("new.png"), pressed_picture(truth, 99));
  const ProgramRun run =
      flat.reconstruct({flat.file("new.png")}, "out", {"--format", "depth,points,ply"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(names_in(flat.folder / "out"),
              testing::UnorderedElementsAre("new.depth.tiff", "new.points.tiff", "new.ply",
                                            "results.jsonl"));
  const cv::Mat depth = cv::imread(flat.file("out/new.depth.tiff"), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_32FC1);
  ASSERT_EQ(depth.size(), truth.size());
  double sum = 0;
  int count = 0;
  for (int v = 0; v < truth.rows; ++v) {
    for (int u = 0; u < truth.cols; ++u) {
      if (truth.at<float>(v, u) < 0.05F) continue;
      sum += std::abs(depth.at<float>(v, u) - truth.at<float>(v, u));
      ++count;
    }
  }
  EXPECT_LT(sum / count, 0.03);
  const auto line = nlohmann::json::parse(text_of(flat.folder.path() / "out" / "results.jsonl"));
  ASSERT_EQ(line.at("regions").size(), 1U);
  EXPECT_NEAR(line.at("regions")[0].at("deepest_mm").get<double>(), 0.45, 0.06);
  EXPECT_FALSE(line.contains("markers"));
  EXPECT_FALSE(line.contains("contact"));
}

TEST(Files, AFullDiskIsToldAndLeavesNothingHalf) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const SmallDisk disk(flat.folder / "disk", 400);  // a depth picture has 300 kB, points 900 kB
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  const ProgramRun run =
      flat.reconstruct({flat.presses[0].string()}, "disk", {"--format", "depth,flags,points"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("space"));
  for (const std::string& name : names_in(flat.folder / "disk"))
    EXPECT_THAT(name, testing::AnyOf("press_0.depth.tiff", "press_0.flags.png"));
}

TEST(Files, AFullDiskLeavesTheFingerAsItWas) {
  const FlatFinger flat;
  const SmallDisk disk(flat.finger(), 64);
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  ASSERT_EQ(flat.make().status, 0);
  const std::string before = text_of(fs::path(flat.finger()) / "finger.yaml");
  const ProgramRun run = flat.calibrate();
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("space"));
  EXPECT_EQ(text_of(fs::path(flat.finger()) / "finger.yaml"), before);
  for (const std::string& name : names_in(flat.finger()))
    EXPECT_THAT(name, testing::EndsWith(name.find("png") == std::string::npos ? "yaml" : ".png"));
}

TEST(Files, AReadOnlyFolderIsTold) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  // Root may write anywhere but where a whole file system forbids it.
  write_text(flat.folder / "file", "");
  const ProgramRun below_a_file = flat.reconstruct({flat.presses[0].string()}, "file/out");
  EXPECT_EQ(below_a_file.status, 1);
  EXPECT_THAT(below_a_file.errors, HasSubstr("file"));
  if (geteuid() == 0) {
    const SmallDisk disk(flat.folder / "disk", 64);
    if (!disk.mounted()) GTEST_SKIP() << disk.problem();
    ASSERT_TRUE(disk.forbid_writing());
    const ProgramRun run =
        flat.reconstruct({flat.presses[0].string()}, "disk", {"--format", "depth,flags,points"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, HasSubstr("disk"));
  } else {
    fs::create_directory(flat.folder / "closed");
    fs::permissions(flat.folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
    const ProgramRun run = flat.reconstruct({flat.presses[0].string()}, "closed");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, HasSubstr("closed"));
  }
}

}  // namespace
}  // namespace alltact::test
