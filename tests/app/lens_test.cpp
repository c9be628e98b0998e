// `alltact lens` on pictures of boards, from the pictures to the camera file and a finger.
#include "core/base/message_json.h"
#include "core/finger/finger.h"
#include "tests/support/boards.h"
#include "tests/support/program.h"

#include <functional>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

using testing::HasSubstr;
using testing::Not;

using Ink = std::function<double(double, double)>;

/// Renders views of a board; the same poses for every pattern.
void write_views(const std::filesystem::path& folder, const CameraParameters& lens,
                 const Board& board, int count, const Ink& ink) {
  const Camera camera = Camera::create(lens).value();
  const made::BoardPainter painter(camera);
  std::mt19937 random(21);
  const auto scene = made::board_scene(camera, board, count, 40, 0, random);
  for (std::size_t i = 0; i < scene.poses.size(); ++i)
    ASSERT_TRUE(cv::imwrite((folder / (scene.views[i].name + ".png")).string(),
                            painter.paint(scene.poses[i], ink, 300 + i)));
}

nlohmann::json lens_json(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"lens", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProgramRun run = run_alltact(all);
  EXPECT_EQ(run.status, 0) << run.errors;
  return run.status == 0 ? nlohmann::json::parse(run.output) : nlohmann::json();
}

void expect_lens(const nlohmann::json& found, const CameraParameters& truth, double within_px) {
  ASSERT_TRUE(found.contains("fx"));
  EXPECT_NEAR(found["fx"], truth.fx_px, within_px);
  EXPECT_NEAR(found["fy"], truth.fy_px, within_px);
  EXPECT_NEAR(found["cx"], truth.cx_px, within_px);
  EXPECT_NEAR(found["cy"], truth.cy_px, within_px);
  EXPECT_LT(found["corner_px"], 0.15);
}

const Board kBoard = made::chessboard(8, 6, 4);

double chess(double x, double y) { return made::chessboard_ink(kBoard, x, y); }

TEST(Lens, ChessboardsGiveTheCameraOfAFinger) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "boards");
  write_views(folder / "boards", made::board_lens(), kBoard, 10, chess);
  ASSERT_TRUE(cv::imwrite((folder / "boards/wall.png").string(),
                          cv::Mat(480, 640, CV_8UC1, cv::Scalar(90))));
  const std::string camera = (folder / "camera.yaml").string();
  const std::vector<std::string> arguments = {
      (folder / "boards").string(), "--board", "8x6", "--square-mm", "4", "-o", camera};
  const auto found = lens_json(arguments);
  expect_lens(found, made::board_lens(), 1.0);
  EXPECT_EQ(found["views_used"], 10);
  EXPECT_EQ(found["pictures"], 11);
  EXPECT_THAT(found["views"].dump(), HasSubstr("hardly any contrast"));
  EXPECT_EQ(found["camera"], camera);
  const auto file = load_camera(camera);
  ASSERT_TRUE(file) << file.error().sentence();
  LensRecord record = file->lens;
  EXPECT_EQ(record["verdict"], found["verdict"]);
  const auto verdict = nlohmann::ordered_json::parse(record["verdict_message"]);
  EXPECT_EQ(message_of(verdict).english(), record["verdict"]);

  std::vector<std::string> in_words = {"lens"};
  in_words.insert(in_words.end(), arguments.begin(), arguments.end());
  const ProgramRun run = run_alltact(in_words);
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.output, HasSubstr("found in 10 of 11 images"));
  EXPECT_THAT(run.output, HasSubstr("Verdict: "));
  EXPECT_THAT(run.errors, HasSubstr("No board: wall"));
  EXPECT_THAT(run.errors, HasSubstr("23 to 31 %"));

  ASSERT_EQ(run_alltact({"new", (folder / "finger").string(), "--camera", camera, "--layer-mm",
                         "1.5", "--width-mm", "24", "--per-row", "6"})
                .status,
            0);
  const std::string finger = text_of(folder / "finger/finger.yaml");
  EXPECT_THAT(finger, HasSubstr("model: brown"));
  EXPECT_THAT(finger, HasSubstr("focal_sd_percent"));  // how the lens was calibrated stays
  EXPECT_THAT(finger, HasSubstr("sd_px: ["));          // with the finger
}

TEST(Lens, OrientationTurnsTheLensToo) {
  const TemporaryFolder folder;
  write_views(folder.path(), made::board_lens(), kBoard, 6, chess);
  const auto found =
      lens_json({folder.path().string(), "--board", "8x6", "--square-mm", "4", "--orientation",
                 "rotate_90", "-o", (folder / "camera.yaml").string()});
  const CameraParameters truth = made::board_lens();
  EXPECT_NEAR(found["fx"], truth.fy_px, 2);
  EXPECT_NEAR(found["cx"], 479 - truth.cy_px, 2);
  EXPECT_NEAR(found["cy"], truth.cx_px, 2);
  EXPECT_THAT(text_of(folder / "camera.yaml"), HasSubstr("size: [480, 640]"));
  EXPECT_THAT(text_of(folder / "camera.yaml"), HasSubstr("orientation: rotate_90"));
}

TEST(Lens, CharucoBoardsThroughAFisheye) {
  const TemporaryFolder folder;
  const auto charuco = cv::aruco::CharucoBoard::create(
      9, 7, 4.0F, 3.0F, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_250));
  cv::Mat print;
  constexpr int kPxPerMm = 20;
  charuco->draw({9 * 4 * kPxPerMm, 7 * 4 * kPxPerMm}, print, 0, 1);
  const Ink ink = [&](double x_mm, double y_mm) {  // our boards begin at the first inner corner
    const double u = (x_mm + 4) * kPxPerMm, v = (y_mm + 4) * kPxPerMm;
    if (u < 0 || v < 0 || u >= print.cols || v >= print.rows) return 200.0;
    return print.at<std::uint8_t>(static_cast<int>(v), static_cast<int>(u)) > 127 ? 200.0 : 25.0;
  };
  const CameraParameters lens = made::board_lens(CameraModel::kFisheye);
  write_views(folder.path(), lens, kBoard, 10, ink);
  const auto found =
      lens_json({folder.path().string(), "--board", "8x6", "--square-mm", "4", "--pattern",
                 "charuco", "--model", "fisheye", "-o", (folder / "camera.yaml").string()});
  expect_lens(found, lens, 1.0);
}

TEST(Lens, DotsAreTakenForWhatTheyAre) {
  const TemporaryFolder folder;
  write_views(folder.path(), made::board_lens(), kBoard, 10,
              [](double x, double y) { return made::dots_ink(kBoard, 0.5, x, y); });
  const auto found = lens_json({folder.path().string(), "--board", "8x6", "--square-mm", "4",
                                "--pattern", "dots", "-o", (folder / "camera.yaml").string()});
  expect_lens(found, made::board_lens(), 1.0);
}

TEST(Lens, AKnownLengthThatLooksTooLargeIsTold) {
  const TemporaryFolder folder;
  const CameraParameters lens = made::board_lens();
  write_views(folder.path(), lens, kBoard, 6, chess);
  // A length of 24 mm at 60 mm, looking 1.3 times as large.
  const double half = 1.3 * 12 / 60 * lens.fy_px * 0.985;  // about what the lens leaves of it
  const std::string ends =
      fmt::format("{},{},{},{}", lens.cx_px, lens.cy_px - half, lens.cx_px, lens.cy_px + half);
  const std::vector<std::string> arguments = {folder.path().string(),
                                              "--board",
                                              "8x6",
                                              "--square-mm",
                                              "4",
                                              "--known-length-mm",
                                              "24",
                                              "--known-ends",
                                              ends,
                                              "-o",
                                              (folder / "camera.yaml").string()};
  const auto in_air = lens_json(arguments);
  EXPECT_NEAR(in_air["scale"]["ratio"], 1.3, 0.03);
}

// Ends of a length that is known, seen through a window that is known: what the program makes of
// them is the length, and without the window it is 1.3 times that.
TEST(Lens, AKnownLengthBehindAWindowMeasuresWhatItIs) {
  const TemporaryFolder folder;
  CameraParameters lens = made::board_lens();
  write_views(folder.path(), lens, kBoard, 10, chess);
  lens.port = FlatPort{5, 3, 1.49, 1.41};
  const Camera behind = Camera::create(lens).value();
  const auto a = behind.project({-3.0, -12.0, 60.0}), b = behind.project({-3.0, 12.0, 60.0});
  ASSERT_TRUE(a && b);
  const std::vector<std::string> arguments = {
      folder.path().string(),
      "--board",
      "8x6",
      "--square-mm",
      "4",
      "--distance-mm",
      "60",
      "--known-length-mm",
      "24",
      "--known-ends",
      fmt::format("{},{},{},{}", a->x(), a->y(), b->x(), b->y()),
      "-o",
      (folder / "camera.yaml").string()};
  EXPECT_GT(lens_json(arguments)["scale"]["ratio"], 1.25);
  auto with_port = arguments;
  with_port.insert(with_port.end(), {"--port", "5,3,1.49,1.41"});
  const auto found = lens_json(with_port);
  EXPECT_NEAR(found["scale"]["seen_mm"], 24.0, 0.03);
  EXPECT_NEAR(found["port"]["seems_mm"], 5 + 3 / 1.49 + 52 / 1.41, 1e-9);
  EXPECT_THAT(text_of(folder / "camera.yaml"), HasSubstr("port: {gap_mm: 5.0, plate_mm: 3.0"));
  // Shorter or longer by a twentieth is told as such.
  auto wrong = with_port;
  *(std::find(wrong.begin(), wrong.end(), "24")) = "25.2";
  wrong.insert(wrong.begin(), "lens");
  EXPECT_THAT(run_alltact(wrong).output, HasSubstr("too small"));
  with_port.insert(with_port.begin(), "lens");
  EXPECT_THAT(run_alltact(with_port).output, HasSubstr("lens and finger agree"));
}

TEST(Lens, WhatCannotBeCalibratedSaysWhyAndWritesNothing) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "two");
  write_views(folder / "two", made::board_lens(), kBoard, 2, chess);
  const std::string camera = (folder / "camera.yaml").string();
  const auto failing = [&](const std::string& inputs, const std::string& board) {
    const ProgramRun run =
        run_alltact({"lens", inputs, "--board", board, "--square-mm", "4", "-o", camera});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, Not(HasSubstr("unexpected")));
    EXPECT_FALSE(std::filesystem::exists(camera));
    return run.errors;
  };
  EXPECT_THAT(failing((folder / "two").string(), "8x6"), HasSubstr("only 2"));
  EXPECT_THAT(failing((folder / "two").string(), "9x7"),
              HasSubstr("this board has 8 x 6 inner corners, not 9 x 7"));
  EXPECT_THAT(failing((folder / "nothing").string(), "8x6"), HasSubstr("nothing"));
  ASSERT_TRUE(
      cv::imwrite((folder / "two/zz.png").string(), cv::Mat(240, 320, CV_8UC1, cv::Scalar(90))));
  EXPECT_THAT(failing((folder / "two").string(), "8x6"), HasSubstr("320 x 240"));
  std::filesystem::remove(folder / "two/zz.png");
  std::filesystem::copy(folder / "two/view_100.png", folder / "two/view_200.png");
  std::filesystem::copy(folder / "two/view_100.png", folder / "two/view_201.png");
  std::filesystem::remove(folder / "two/view_101.png");
  EXPECT_THAT(failing((folder / "two").string(), "8x6"), HasSubstr("in the same position"));
}

}  // namespace
}  // namespace alltact::test
