#include "calibration/lens/calibrate_lens.h"

#include "calibration/lens/board_views.h"
#include "core/open/open_source.h"
#include "tests/support/boards.h"

#include <algorithm>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using made::board_lens;
using made::board_scene;
using made::chessboard;
using testing::HasSubstr;
using testing::Property;

made::BoardScene usual_scene(int seed, int count = 14) {
  std::mt19937 random(seed);
  return board_scene(Camera::create(board_lens()).value(), chessboard(), count, 40, 0.15, random);
}

LensCalibration calibrated(const std::vector<BoardView>& views) {
  auto found = calibrate_lens(views, {640, 480}, {}, {});
  EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
  return found ? std::move(found).value() : LensCalibration{};
}

TEST(CalibrateLens, OrderOfViewsDoesNotMatter) {
  auto scene = usual_scene(1);
  const LensCalibration first = calibrated(scene.views);
  std::shuffle(scene.views.begin(), scene.views.end(), std::mt19937(9));
  const LensCalibration second = calibrated(scene.views);
  EXPECT_EQ(first.fit.lens, second.fit.lens);  // to the last bit
  EXPECT_EQ(first.verdict.sentence, second.verdict.sentence);
}

TEST(CalibrateLens, UnitsOfTheBoardDoNotMatter) {
  auto scene = usual_scene(2);
  const LensCalibration mm = calibrated(scene.views);
  for (BoardView& view : scene.views)
    for (Eigen::Vector3d& place : view.board_mm) place *= 25.4;
  const LensCalibration other = calibrated(scene.views);
  EXPECT_NEAR(mm.fit.lens.fx_px, other.fit.lens.fx_px, 1e-5);
  EXPECT_NEAR(mm.fit.sd(0), other.fit.sd(0), 1e-5);
}

TEST(CalibrateLens, AMirroredCameraHasTheMirroredLens) {
  auto scene = usual_scene(3);
  const LensCalibration straight = calibrated(scene.views);
  for (BoardView& view : scene.views)
    for (Eigen::Vector2d& pixel : view.pixels)
      pixel = oriented_pixel(pixel, {640, 480}, Orientation::kFlipU);
  const LensCalibration mirrored = calibrated(scene.views);
  EXPECT_NEAR(mirrored.fit.lens.fx_px, straight.fit.lens.fx_px, 1e-4);
  EXPECT_NEAR(mirrored.fit.lens.cx_px, 639 - straight.fit.lens.cx_px, 1e-4);
  EXPECT_NEAR(mirrored.fit.lens.distortion[3], -straight.fit.lens.distortion[3], 1e-6);
}

TEST(CalibrateLens, WhereTheBoardsOriginIsDoesNotMatter) {
  auto scene = usual_scene(4);
  const LensCalibration first = calibrated(scene.views);
  for (BoardView& view : scene.views)
    for (Eigen::Vector3d& place : view.board_mm) place += Eigen::Vector3d(40, -25, 0);
  EXPECT_NEAR(calibrated(scene.views).fit.lens.fx_px, first.fit.lens.fx_px, 1e-5);
}

TEST(CalibrateLens, TellsWhatTheLensIsWorth) {
  const LensCalibration found = calibrated(usual_scene(5, 20).views);
  EXPECT_NEAR(found.fit.lens.fx_px, 521.4, 5 * found.fit.sd(0));
  EXPECT_NEAR(found.fit.sigma_px, 0.15, 0.015);
  ASSERT_TRUE(found.held_out);
  EXPECT_GT(found.held_out->error_px, 0.9 * found.fit.sigma_px);
  EXPECT_LT(found.held_out->error_px, 1.3 * found.fit.sigma_px);
  ASSERT_TRUE(found.halves);
  EXPECT_LT(found.halves->difference.median_px, 1.0);
  EXPECT_EQ(found.verdict.grade, Grade::kGood) << found.verdict.sentence.english();
}

TEST(CalibrateLens, ABentViewIsPutAsideAndSaysSo) {
  auto scene = usual_scene(6);
  std::mt19937 random(66);
  const Camera camera = Camera::create(board_lens()).value();
  BoardView& bent = scene.views[4];
  for (std::size_t i = 0; i < bent.pixels.size(); ++i) {
    Eigen::Vector3d place = bent.board_mm[i];
    place.z() = 1.2 * std::pow((place.x() - 10) / 10, 2);
    bent.pixels[i] = camera.project(scene.poses[4](place)).value();
  }
  const LensCalibration found = calibrated(scene.views);
  EXPECT_THAT(found.views[4].rejection.english(), HasSubstr("bent"));
  EXPECT_EQ(found.used.size(), scene.views.size() - 1);
  EXPECT_NEAR(found.fit.lens.fx_px, 521.4, 5 * found.fit.sd(0));
}

TEST(CalibrateLens, ABlurredViewIsPutAsideAndSaysSo) {
  auto scene = usual_scene(7);
  std::mt19937 random(77);
  std::normal_distribution<double> noise(0, 1.0);
  scene.views[2].edge_px = 6;
  for (Eigen::Vector2d& pixel : scene.views[2].pixels) pixel.x() += noise(random);
  EXPECT_THAT(calibrated(scene.views).views[2].rejection.english(), HasSubstr("blurred"));
}

TEST(CalibrateLens, ABoardBentInAllViewsIsNoticed) {
  std::mt19937 random(8);
  const Camera camera = Camera::create(board_lens()).value();
  auto scene = board_scene(camera, chessboard(), 14, 40, 0, random);
  std::normal_distribution<double> noise(0, 0.1);
  for (std::size_t k = 0; k < scene.views.size(); ++k)
    for (std::size_t i = 0; i < scene.views[k].pixels.size(); ++i) {
      Eigen::Vector3d place = scene.views[k].board_mm[i];
      place.z() = 0.4 * std::pow((place.x() - 10) / 10, 2);
      scene.views[k].pixels[i] = camera.project(scene.poses[k](place)).value() +
                                 Eigen::Vector2d(noise(random), noise(random));
    }
  const LensCalibration found = calibrated(scene.views);
  EXPECT_THAT(found.remarks,
              testing::Contains(Property(&Message::english, HasSubstr("bent by about"))));
  EXPECT_THAT(calibrated(usual_scene(9).views).remarks,
              testing::Not(testing::Contains(Property(&Message::english, HasSubstr("not flat")))));
}

TEST(CalibrateLens, RepeatsAreNoNewViews) {
  auto scene = usual_scene(10, 3);
  std::vector<BoardView> same(5, scene.views[0]);
  for (std::size_t i = 0; i < same.size(); ++i) same[i].name = "same_" + std::to_string(i);
  const auto alike = calibrate_lens(same, {640, 480}, {}, {});
  ASSERT_FALSE(alike);
  EXPECT_THAT(alike.error().what.english(),
              HasSubstr("all 5 views show the board in the same position"));
  same.resize(2);
  const auto few = calibrate_lens(same, {640, 480}, {}, {});
  ASSERT_FALSE(few);
  EXPECT_THAT(few.error().what.english(), HasSubstr("only 2"));
}

TEST(CalibrateLens, StraightViewsAreNotFitAndSayWhatIsMissing) {
  std::mt19937 random(11);
  const auto scene =
      board_scene(Camera::create(board_lens()).value(), chessboard(), 6, 3, 0.2, random);
  const auto found = calibrate_lens(scene.views, {640, 480}, {}, {});
  if (!found) {
    EXPECT_THAT(found.error().advice.english(), HasSubstr("tilted"));
    return;
  }
  EXPECT_EQ(found->verdict.grade, Grade::kUnfit) << found->verdict.sentence.english();
  EXPECT_THAT(found->verdict.sentence.english(), HasSubstr("more, tilted"));
}

TEST(CalibrateLens, MissingPlacesAreNamed) {
  auto scene = usual_scene(12, 60);
  std::vector<BoardView> left;
  for (const BoardView& view : scene.views)
    if (std::all_of(view.pixels.begin(), view.pixels.end(),
                    [](const Eigen::Vector2d& pixel) { return pixel.x() < 400; }))
      left.push_back(view);
  ASSERT_GE(left.size(), 8U);
  const LensCalibration found = calibrated(left);
  EXPECT_THAT(found.coverage.unseen, testing::Contains(Property(&Message::english, "right edge")));
  EXPECT_THAT(found.coverage.advice.english(), HasSubstr("right edge"));
  EXPECT_FALSE(found.coverage.enough);
  EXPECT_NE(found.verdict.grade, Grade::kGood);
}

TEST(CalibrateLens, StoppedBeforeThereIsALensSaysSo) {
  Job job;
  job.request_stop();
  const auto found = calibrate_lens(usual_scene(13).views, {640, 480}, {}, job);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().what.english(), HasSubstr("stopped"));
}

TEST(LensVerdict, GradesByTheWorstEvidence) {
  LensCalibration evidence;
  evidence.fit.lens.fx_px = 500, evidence.fit.sigma_px = 0.2;
  evidence.focal_sd_part = 0.001;
  evidence.held_out = HeldOut{0.21, Eigen::Vector4d::Constant(0.5)};
  evidence.coverage.enough = true;
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kGood);
  evidence.coverage.enough = false;
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kUsable);
  evidence.held_out->error_px = 2;
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kUnfit);
  evidence.held_out.reset();
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kUnproven);
  evidence.focal_sd_part = 0.01;
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kUnfit);
  evidence.focal_sd_part = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lens_verdict(evidence, 60).grade, Grade::kUnfit);
}

TEST(Dots, ThePictureOfADiscIsNotCentredOnItsCentre) {
  const CameraParameters lens = board_lens();
  BoardPose pose;
  pose.turn = {0.7, 0.2, 0};
  pose.shift_mm = {2, 1, 20};
  BoardView view;
  view.board_mm = {{0, 0, 0}, {4, 0, 0}};
  // Centroid over the disc's area, ring by ring: no outline in it.
  const Camera camera = Camera::create(lens).value();
  for (const Eigen::Vector3d& place : view.board_mm) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0;
    const auto at = [&](double x, double y) {
      return camera.project(pose(place + Eigen::Vector3d(x, y, 0))).value();
    };
    for (double x = -1.4975; x < 1.5; x += 0.005)
      for (double y = -1.4975; y < 1.5; y += 0.005) {
        if (x * x + y * y > 2.25) continue;
        const Eigen::Vector2d here = at(x, y), dx = at(x + 1e-4, y) - here,
                              dy = at(x, y + 1e-4) - here;
        const double area = std::abs(dx.x() * dy.y() - dx.y() * dy.x());
        sum += area * here;
        weight += area;
      }
    view.pixels.emplace_back(sum / weight);
  }
  const BoardView corrected = without_dot_bias(view, lens, pose, 1.5);
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const Eigen::Vector2d centre = camera.project(pose(view.board_mm[i])).value();
    EXPECT_GT((view.pixels[i] - centre).norm(), 0.5);
    EXPECT_LT((corrected.pixels[i] - centre).norm(), 0.02);
  }
}

TEST(RealBoards, FisheyeFocalLengthIsThePublishedOne) {
  const std::filesystem::path folder =
      std::filesystem::path(ALLTACT_SOURCE_DIR) / ".." / "shared" / "data" / "fisheye_boards";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no fisheye boards in " << folder;
  Board board = chessboard(6, 6, 10);
  const auto source = open_source({folder});
  ASSERT_TRUE(source);
  const auto views = find_boards(**source, board, Orientation::kNone, {});
  ASSERT_TRUE(views) << views.error().sentence();
  EXPECT_GE(views->views.size(), 15U);
  LensSettings settings;
  settings.model = CameraModel::kFisheye;
  const auto found = calibrate_lens(views->views, views->size, settings, {});
  ASSERT_TRUE(found) << found.error().sentence();
  std::printf("[ figures  ] real fisheye boards: %zu views, fx %.2f +- %.2f px, corners %.3f px\n",
              found->used.size(), found->fit.lens.fx_px,
              found->focal_sd_part * found->fit.lens.fx_px, found->fit.sigma_px);
  // Published without an uncertainty; ours must cover it.
  EXPECT_NEAR(found->fit.lens.fx_px, 284.3, 3 * found->focal_sd_part * found->fit.lens.fx_px);
  EXPECT_NEAR(found->fit.lens.fx_px, 284.3, 0.01 * 284.3);
}

}  // namespace
}  // namespace alltact
