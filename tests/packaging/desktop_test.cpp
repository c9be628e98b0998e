// What desktops, software centres and file managers are told, judged by their own programs.
#include "core/base/zip_file.h"
#include "core/finger/finger.h"
#include "core/image/image_file.h"
#include "core/mesh/surface_file.h"
#include "tests/packaging/quoted.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/program.h"

#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kDesktop = kTop / "packaging/desktop";

TEST(Desktop, EntryAndMetadataAreValid) {
  const ProgramRun entry =
      run_shell("desktop-file-validate " + quoted(kDesktop / "alltact-studio.desktop"));
  EXPECT_EQ(entry.status, 0);
  EXPECT_EQ(entry.output + entry.errors, "");
  const ProgramRun metadata =
      run_shell("appstreamcli validate --no-net --pedantic --strict " +
                quoted(fs::path(ALLTACT_BUILT_SHARE) / "alltact-studio.metainfo.xml"));
  EXPECT_EQ(metadata.status, 0) << metadata.output << metadata.errors;
}

TEST(Desktop, TheNewestReleaseIsThisVersion) {
  const std::string metadata = text_of(kDesktop / "alltact-studio.metainfo.xml.in");
  const std::string cmake = text_of(kTop / "CMakeLists.txt");
  std::smatch released, version;
  ASSERT_TRUE(std::regex_search(metadata, released, std::regex("<release version=\"([0-9.]+)\"")));
  ASSERT_TRUE(std::regex_search(cmake, version, std::regex("project\\(alltact VERSION ([0-9.]+)")));
  EXPECT_EQ(released[1], version[1]);
  const TemporaryFolder folder;
  const ProgramRun log = run_shell(quoted(kTop / "packaging/debian/changelog-of-releases") + " " +
                                   quoted(kDesktop / "alltact-studio.metainfo.xml.in") +
                                   " 'A Person <a@example.org>'");
  ASSERT_EQ(log.status, 0) << log.errors;
  EXPECT_THAT(log.output, testing::StartsWith("alltact (" + version[1].str() + ") bookworm;"));
  EXPECT_THAT(text_of(kTop / "CHANGELOG.md"), HasSubstr("\n## " + version[1].str() + ", "));
}

TEST(Desktop, TheIconComesInEverySizeAndShowsSomething) {
  for (const int size : {16, 22, 24, 32, 48, 64, 128, 256, 512}) {
    const cv::Mat icon = cv::imread(
        std::string(ALLTACT_BUILT_SHARE) + "/icons/alltact-studio_" + std::to_string(size) + ".png",
        cv::IMREAD_UNCHANGED);
    ASSERT_EQ(icon.size(), cv::Size(size, size));
    ASSERT_EQ(icon.type(), CV_8UC4);
    cv::Mat opacity;
    cv::extractChannel(icon, opacity, 3);
    const double covered = cv::mean(opacity)[0] / 255;
    EXPECT_GT(covered, 0.3) << size;
    EXPECT_LT(covered, 0.95) << size;
  }
}

/// A home whose file manager has learnt our kinds of files, and files of every kind.
class Kinds : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(data_ / "mime/packages");
    fs::copy(kDesktop / "alltact.xml", data_ / "mime/packages");
    const ProgramRun learnt = run_shell("update-mime-database -V " + quoted(data_ / "mime"));
    ASSERT_EQ(learnt.status, 0) << learnt.errors;
  }
  std::string kind_of(const fs::path& file) {
    const ProgramRun run = run_shell("XDG_DATA_HOME=" + quoted(data_) +
                                     " gio info -a standard::content-type " + quoted(file));
    std::smatch found;
    if (!std::regex_search(run.output, found, std::regex("content-type: (\\S+)")))
      return run.errors;
    return found[1];
  }
  TemporaryFolder folder_;
  fs::path data_ = folder_ / "data";
};

TEST_F(Kinds, YamlFilesAreToldApartByWhatStandsInThem) {
  int scenes = 0;
  for (const auto& scene : fs::directory_iterator(kTop / "resources/scenes")) {
    EXPECT_EQ(kind_of(scene.path()), "application/x-alltact-scene") << scene.path();
    if (++scenes == 8) break;
  }
  write_flat_camera(folder_ / "camera.yaml");
  ASSERT_EQ(run_alltact({"new", (folder_ / "finger").string(), "--camera",
                         (folder_ / "camera.yaml").string(), "--layer-mm", "3", "--kind", "flat"})
                .status,
            0);
  EXPECT_EQ(kind_of(folder_ / "finger/finger.yaml"), "application/x-alltact-finger");
  write_text(folder_ / "lens.yaml",
             "model: brown\nsize: [960, 540]\nfx: 523.9\nfy: 523.9\ncx: 479.5\ncy: 269.5\n"
             "distortion: [0.1, 0, 0, 0, 0]\norientation: none\n");
  EXPECT_EQ(kind_of(folder_ / "lens.yaml"), "application/x-alltact-camera");
  write_text(folder_ / "gripper.yaml", "format: alltact-gripper/1\nname: lab\n");
  EXPECT_EQ(kind_of(folder_ / "gripper.yaml"), "application/x-alltact-gripper");
  // Other people's.
  write_text(folder_ / "camera_info.yaml",
             "image_width: 640\ncamera_name: x\ndistortion_model: plumb_bob\n");
  EXPECT_EQ(kind_of(folder_ / "camera_info.yaml"), "application/x-yaml");
  write_text(folder_ / "any.yaml", "finger: x\neffects: none\n");
  EXPECT_EQ(kind_of(folder_ / "any.yaml"), "application/x-yaml");
}

TEST_F(Kinds, AFingersZipIsNoOtherZip) {
  const Job job;
  ASSERT_TRUE(write_zip(folder_ / "a.zip",
                        {{"calibration.json", {}, std::string(3000, 'x') + "{}"},
                         {"finger/finger.yaml", {}, "format: alltact-finger/1\n"}},
                        job)
                  .ok());
  ASSERT_TRUE(write_zip(folder_ / "b.zip", {{"finger/finger.yaml", {}, "x"}}, job).ok());
  EXPECT_EQ(kind_of(folder_ / "a.zip"), "application/x-alltact-finger-zip");
  EXPECT_EQ(kind_of(folder_ / "b.zip"), "application/zip");
}

/// Depth of a slope with a hole, and a mesh of it.
cv::Mat slope_mm() {
  cv::Mat depth(40, 80, CV_32FC1);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) depth.at<float>(v, u) = 0.01F * static_cast<float>(u);
  depth(cv::Rect(0, 0, 10, 10)).setTo(std::numeric_limits<float>::quiet_NaN());
  return depth;
}

TEST_F(Kinds, AFileManagerGetsAThumbnailOfDepthAndOfMeshes) {
  const std::string entry = text_of(kDesktop / "alltact.thumbnailer");
  std::smatch command, kinds;
  ASSERT_TRUE(std::regex_search(entry, command, std::regex("\nExec=alltact (.*)\n")));
  ASSERT_TRUE(std::regex_search(entry, kinds, std::regex("\nMimeType=(.*)\n")));
  const cv::Mat depth = slope_mm();
  cv::Mat points(depth.size(), CV_32FC3);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      points.at<cv::Vec3f>(v, u) =
          cv::Vec3f(0.5F * float(u), 0.5F * float(v), 40 - depth.at<float>(v, u));
  write_text(folder_ / "x.depth.tiff", depth_tiff(depth));
  write_text(folder_ / "x.depth16.png", depth_png(depth));
  for (const char* name : {"x.ply", "x.vtp", "x.stl", "x.glb"})
    ASSERT_TRUE(write_surface(folder_ / name, points, depth).ok());
  for (const char* name : {"x.depth.tiff", "x.depth16.png", "x.ply", "x.vtp", "x.stl", "x.glb"}) {
    const fs::path file = folder_ / name, small = folder_ / "small.png";
    EXPECT_THAT(kinds[1].str(), HasSubstr(kind_of(file) + ";")) << name;
    std::string called = std::regex_replace(command[1].str(), std::regex("%i"), quoted(file));
    called = std::regex_replace(called, std::regex("%o"), quoted(small));
    called = std::regex_replace(called, std::regex("%s"), "128");
    const ProgramRun run = run_shell(std::string("'") + ALLTACT_PROGRAM + "' " + called);
    ASSERT_EQ(run.status, 0) << name << run.errors;
    const cv::Mat image = cv::imread(small.string(), cv::IMREAD_UNCHANGED);
    EXPECT_EQ(std::max(image.cols, image.rows), 128) << name;
    EXPECT_EQ(image.type(), CV_8UC4) << name;
    fs::remove(small);
  }
}

}  // namespace
}  // namespace alltact::test
