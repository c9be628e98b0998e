// What `alltact export` leaves for other programs, and what they make of it.
#include "tests/support/flat_finger.h"
#include "tests/support/python_loader.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Export, CarriesTheSameNumbers) {
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: brown\nsize: [640, 480]\nfx: 411.5\nfy: 412.25\ncx: 320.5\ncy: 239.75\n"
             "distortion: [-0.11, 0.02, 0.001, -0.002]\norientation: none\n");
  const std::string finger = (folder / "finger").string();
  ASSERT_EQ(make_fin_ray(finger, folder / "camera.yaml").status, 0);
  const ProgramRun run =
      run_alltact({"export", finger, "--to", "opencv,json", "-o", (folder / "out").string()});
  ASSERT_EQ(run.status, 0) << run.errors;
  const cv::FileStorage file((folder / "out").string() + "/camera.opencv.yaml",
                             cv::FileStorage::READ);
  ASSERT_TRUE(file.isOpened());
  cv::Mat matrix, distortion;
  file["camera_matrix"] >> matrix;
  file["distortion_coefficients"] >> distortion;
  EXPECT_EQ(static_cast<int>(file["image_width"]), 640);
  EXPECT_EQ(matrix.at<double>(0, 0), 411.5);
  EXPECT_EQ(matrix.at<double>(1, 1), 412.25);
  EXPECT_EQ(matrix.at<double>(0, 2), 320.5);
  EXPECT_EQ(matrix.at<double>(1, 2), 239.75);
  ASSERT_EQ(distortion.total(), 5U);
  EXPECT_EQ(distortion.at<double>(3), -0.002);
  EXPECT_EQ(distortion.at<double>(4), 0.0);
  const auto json = nlohmann::json::parse(text_of(folder.path() / "out" / "calibration.json"));
  EXPECT_EQ(json.at("camera").at("fy_px"), 412.25);
  EXPECT_EQ(json.at("face").at("width_mm"), 24.0);
  EXPECT_FALSE(json.contains("mapping")) << "absent, never zero";
}

TEST(Export, AnOrthographicCameraHasNoCameraMatrix) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  const ProgramRun run =
      run_alltact({"export", flat.finger(), "--to", "json,ros,zip", "-o", flat.file("out")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("an orthographic camera has no camera matrix"));
  EXPECT_FALSE(fs::exists(flat.file("out"))) << "nothing where a part is refused";
}

TEST(Export, ListsWhatItWroteAndReplacesWhatWasThere) {
  const TemporaryFolder folder;
  write_text(folder / "camera.yaml",
             "model: fisheye\nsize: [640, 480]\nfx: 411.5\nfy: 412.25\ncx: 320.5\ncy: 239.75\n"
             "distortion: [-0.01, 0.002]\norientation: none\n");
  const std::string finger = (folder / "finger").string();
  ASSERT_EQ(make_fin_ray(finger, folder / "camera.yaml").status, 0);
  const std::string out = (folder / "out").string();
  fs::create_directory(out);
  write_text(folder / "out/camera_info.yaml", "older");
  write_text(folder / "out/notes.txt", "mine");
  const ProgramRun run =
      run_alltact({"export", finger, "--to", "zip,ros,opencv,json", "-o", out, "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto files = nlohmann::json::parse(run.output).at("files");
  EXPECT_THAT(
      files.get<std::vector<std::string>>(),
      ElementsAre(out + "/camera.opencv.yaml", out + "/camera_info.yaml", out + "/parameters.yaml",
                  out + "/calibration.json", out + "/finger.zip"));
  EXPECT_THAT(text_of(folder / "out/camera_info.yaml"),
              HasSubstr("distortion_model: equidistant\n"));
  EXPECT_EQ(text_of(folder / "out/notes.txt"), "mine");
  const auto first = contents_of(out);
  ASSERT_EQ(run_alltact({"export", finger, "--to", "zip,ros,opencv,json", "-o", out}).status, 0);
  EXPECT_EQ(contents_of(out), first);
}

TEST(Export, PythonMeasuresAFlatSensorAsTheProgramDoes) {
  const FlatFinger flat;
  ASSERT_EQ(flat.make().status, 0);
  ASSERT_EQ(flat.calibrate().status, 0);
  const fs::path image = flat.file("new.png");
  cv::imwrite(image.string(), pressed_picture(ball_depth_mm(170, 110, 0.45), 99));
  ASSERT_EQ(flat.reconstruct({image.string()}, "out", {"--format", "depth"}).status, 0);
  const DepthDifference difference =
      python_against_program(flat.finger(), {image}, flat.file("out"));
  std::printf("%s\n", difference.words().c_str());
  ASSERT_GT(difference.in_contact.size(), 1000U);
  EXPECT_LT(difference.part(difference.all, 0.5), 0.002);
  EXPECT_LT(difference.part(difference.all, 0.95), 0.01);
  EXPECT_LT(difference.part(difference.in_contact, 0.5), 0.005);
  EXPECT_LT(difference.part(difference.in_contact, 0.95), 0.01);
  EXPECT_LT(difference.missing_part(), 0.05);
}

}  // namespace
}  // namespace alltact::test
