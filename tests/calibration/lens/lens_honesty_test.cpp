// Whether the standard deviations that a lens is given with are honest: on worlds with known truth,
// and on real boards, where halves of the images must agree within them.
#include "calibration/lens/board_views.h"
#include "calibration/lens/calibrate_lens.h"
#include "core/open/open_source.h"
#include "tests/support/boards.h"

#include <cstdio>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

struct World {
  int views = 12;
  double noise_px = 0.2, tilt_deg = 35, bend_mm = 0, stretch = 0;
};

LensCalibration calibrated_in(const World& world, int seed, const CameraParameters& truth) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const Camera camera = Camera::create(truth).value();
  const Board board = made::chessboard();
  auto scene = made::board_scene(camera, board, world.views, world.tilt_deg, 0, random);
  std::normal_distribution<double> noise(0, world.noise_px);
  for (std::size_t k = 0; k < scene.views.size(); ++k)
    for (std::size_t i = 0; i < scene.views[k].pixels.size(); ++i) {
      Eigen::Vector3d place = scene.views[k].board_mm[i];
      place.z() = world.bend_mm * std::pow((place.x() - 10) / 10, 2);
      place.x() *= 1 + world.stretch;
      scene.views[k].pixels[i] = camera.project(scene.poses[k](place)).value() +
                                 Eigen::Vector2d(noise(random), noise(random));
    }
  auto found = calibrate_lens(scene.views, camera.size(), {}, {});
  EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
  return found ? std::move(*found) : LensCalibration{};
}

/// Root mean square of the errors of fx over their estimated standard deviations.
double error_in_sd(const std::vector<std::pair<World, int>>& worlds) {
  double sum = 0;
  for (const auto& [world, seed] : worlds) {
    const CameraParameters truth = made::board_lens();
    const LensCalibration found = calibrated_in(world, seed, truth);
    const double error = (found.fit.lens.fx_px - truth.fx_px) / found.fit.lens.sd_px[0];
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(worlds.size()));
}

TEST(LensHonesty, ErrorsOfTheFocalLengthAreAsLargeAsEstimated) {
  std::vector<std::pair<World, int>> independent, bent;
  std::mt19937 random(77);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int seed = 0; seed < 24; ++seed) {
    World world;
    world.views = 5 + seed / 2;
    world.noise_px = 0.05 + 0.4 * unit(random);
    world.tilt_deg = 15 + 30 * unit(random);
    independent.emplace_back(world, 500 + seed);
    world.views = 8 + seed / 2;
    world.noise_px = 0.1;
    world.bend_mm = (seed % 2 == 0 ? 1 : -1) * (0.05 + 0.3 * unit(random));
    bent.emplace_back(world, 900 + seed);
  }
  const double honest = error_in_sd(independent), with_bend = error_in_sd(bent);
  std::printf(
      "[ figures  ] error of fx over its sd, rms: %.2f in %zu worlds, %.2f with bent boards\n",
      honest, independent.size(), with_bend);
  EXPECT_LT(honest, 1.3);
  EXPECT_GT(honest, 0.5);  // no sd is widened without need
  EXPECT_LT(with_bend, 1.3);
}

TEST(LensHonesty, AStretchedBoardAndStretchedPixelsAreReported) {
  World world;
  world.views = 16;
  world.noise_px = 0.1;
  world.stretch = 0.03;
  const LensCalibration board = calibrated_in(world, 31, made::board_lens());
  const auto texts = [](const LensCalibration& found) {
    std::string all;
    for (const Message& remark : found.remarks) all += remark.english() + "\n";
    return all;
  };
  // Tilted boards separate the board from the pixels.
  EXPECT_THAT(texts(board), HasSubstr("wider than they are high"));
  EXPECT_NEAR(board.shape.value().stretch, 0.03, 0.002);
  EXPECT_THAT(board.verdict.sentence.english(), HasSubstr("stretched by 3.0 %"));
  EXPECT_NE(board.verdict.grade, Grade::kGood);
  // The true lens is within the widened standard deviation.
  EXPECT_NEAR(board.fit.lens.fx_px, made::board_lens().fx_px, 2 * board.fit.lens.sd_px[0]);

  world.stretch = 0;
  CameraParameters wide = made::board_lens();
  wide.fx_px *= 1.05;
  const LensCalibration image = calibrated_in(world, 32, wide);
  EXPECT_EQ(pixel_aspect(image).cause, AspectCause::kImage) << texts(image);
  EXPECT_THAT(texts(image), HasSubstr("although the board is square"));
  EXPECT_NEAR(image.fit.lens.fx_px, wide.fx_px, 3 * image.fit.lens.sd_px[0]);

  // Straight boards do not.
  world.stretch = 0.03;
  world.tilt_deg = 8;
  world.noise_px = 0.2;
  const LensCalibration straight = calibrated_in(world, 34, made::board_lens());
  if (pixel_aspect(straight).cause != AspectCause::kNone) {
    EXPECT_NE(pixel_aspect(straight).cause, AspectCause::kImage) << texts(straight);
    EXPECT_THAT(straight.verdict.sentence.english(), HasSubstr("likely out of square"));
  }
  EXPECT_EQ(straight.verdict.grade, Grade::kUnfit);
  EXPECT_NEAR(straight.fit.lens.fx_px, made::board_lens().fx_px, 3 * straight.fit.lens.sd_px[0]);

  world = World{16, 0.1};
  const LensCalibration square = calibrated_in(world, 33, made::board_lens());
  EXPECT_EQ(pixel_aspect(square).cause, AspectCause::kNone);
}

TEST(LensHonesty, SquaresInMetresAreNoticed) {
  std::mt19937 random(4);
  auto scene = made::board_scene(Camera::create(made::board_lens()).value(), made::chessboard(), 10,
                                 35, 0.1, random);
  const auto remarks = [&](double scale) {
    auto views = scene.views;
    for (BoardView& view : views)
      for (Eigen::Vector3d& place : view.board_mm) place *= scale;
    const auto found = calibrate_lens(views, {640, 480}, {}, {});
    std::string all;
    if (found)
      for (const Message& remark : found->remarks) all += remark.english() + "\n";
    return all;
  };
  EXPECT_THAT(remarks(0.001), HasSubstr("not in metres"));
  EXPECT_THAT(remarks(1000), HasSubstr("not in micrometres"));
  EXPECT_EQ(remarks(1).find("millimetres"), std::string::npos);
}

// Real boards.

std::filesystem::path data_folder(const std::string& name) {
  return std::filesystem::path(ALLTACT_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

struct RealSet {
  std::string folder;
  int columns, rows;
  double square_mm;
  CameraModel model = CameraModel::kBrown;
};

const std::vector<RealSet> kSets{
    {"photonvision_boards/piCam_640_480_1", 7, 7, 25.4},
    {"photonvision_boards/piCam_320_240_1", 7, 7, 25.4},
    {"photonvision_boards/lifecam_2024-01-02_lifecam_480", 10, 10, 25.4},
    {"photonvision_boards/lifecam_2024-01-02_lifecam_1280", 10, 10, 25.4},
    {"fisheye_boards", 6, 6, 10, CameraModel::kFisheye}};

Result<LensViews> views_of(const RealSet& set) {
  const auto source = open_source({data_folder(set.folder)});
  if (!source) return source.error();
  return find_boards(**source, made::chessboard(set.columns, set.rows, set.square_mm),
                     Orientation::kNone, {});
}

TEST(LensHonesty, HalvesOfRealViewsAgreeWithinTheEstimatedDeviation) {
  std::vector<double> focal_px, sd_px;
  for (const RealSet& set : kSets) {
    if (!std::filesystem::exists(data_folder(set.folder)))
      GTEST_SKIP() << "no boards in " << data_folder(set.folder);
    SCOPED_TRACE(set.folder);
    const auto found = views_of(set);
    ASSERT_TRUE(found) << found.error().sentence();
    LensSettings settings;
    settings.model = set.model;
    const auto all = calibrate_lens(found->views, found->size, settings, {});
    ASSERT_TRUE(all) << all.error().sentence();
    std::array<std::vector<BoardView>, 2> halves;
    for (std::size_t i = 0; i < all->used.size(); ++i) halves[i % 2].push_back(all->used[i]);
    std::array<Eigen::Vector2d, 2> numbers;
    for (std::size_t half = 0; half < 2; ++half) {
      const auto one = calibrate_lens(halves[half], found->size, settings, {});
      ASSERT_TRUE(one) << one.error().sentence();
      numbers[half] = {one->fit.lens.fx_px, one->fit.lens.fy_px};
    }
    const CameraParameters& lens = all->fit.lens;
    std::printf(
        "[ figures  ] %s: fx %.1f +- %.1f (covariance %.1f), halves %.1f and %.1f; fx/fy %.4f; "
        "%s\n",
        set.folder.c_str(), lens.fx_px, all->fit.lens.sd_px[0], all->fit.sd(0), numbers[0].x(),
        numbers[1].x(), lens.fx_px / lens.fy_px, all->verdict.sentence.english().c_str());
    // The sd of all views is half of that of a difference of halves.
    EXPECT_LT(std::abs(numbers[0].x() - numbers[1].x()) / 2, 1.5 * all->fit.lens.sd_px[0]);
    EXPECT_LT(std::abs(numbers[0].y() - numbers[1].y()) / 2, 1.5 * all->fit.lens.sd_px[1]);
    focal_px.push_back(lens.fx_px);
    sd_px.push_back(all->fit.lens.sd_px[0]);
  }
  // The same camera at half the size.
  EXPECT_NEAR(focal_px[0], 2 * focal_px[1], std::hypot(sd_px[0], 2 * sd_px[1]));
}

Result<LensCalibration> calibrated_set(const RealSet& set) {
  const auto found = views_of(set);
  if (!found) return found.error();
  return calibrate_lens(found->views, found->size, {}, {});
}

TEST(LensHonesty, RealBoardsOutOfSquareAndHalvesThatDisagreeAreReported) {
  if (!std::filesystem::exists(data_folder(kSets[0].folder)))
    GTEST_SKIP() << "no boards in " << data_folder(kSets[0].folder);
  const auto picam = calibrated_set(kSets[0]), lifecam = calibrated_set(kSets[2]);
  ASSERT_TRUE(picam && lifecam);
  EXPECT_EQ(picam->verdict.grade, Grade::kUnfit);
  EXPECT_THAT(picam->verdict.sentence.english(), HasSubstr("likely out of square"));
  EXPECT_NE(pixel_aspect(*picam).cause, AspectCause::kNone);
  EXPECT_NEAR(pixel_aspect(*picam).ratio, 1.032, 0.005);
  EXPECT_EQ(lifecam->verdict.grade, Grade::kUnfit);
  EXPECT_THAT(lifecam->verdict.sentence.english(), HasSubstr("two halves of the views give f"));
  EXPECT_THAT(lifecam->verdict.sentence.english(), HasSubstr("the board is bent"));
  // The published focal lengths lie within the estimated deviation.
  EXPECT_NEAR(lifecam->fit.lens.fx_px, 699.38, 2 * lifecam->fit.lens.sd_px[0]);
  EXPECT_NEAR(lifecam->fit.lens.fy_px, 677.72, 2 * lifecam->fit.lens.sd_px[1]);
}

TEST(LensVerdict, FxAndFyThatDifferAreBlamedOnWhatExplainsThem) {
  LensCalibration evidence;
  evidence.fit.lens.fx_px = 515, evidence.fit.lens.fy_px = 500, evidence.fit.sigma_px = 0.2;
  evidence.fit.covariance = Eigen::MatrixXd::Identity(9, 9);
  EXPECT_EQ(pixel_aspect(evidence).cause, AspectCause::kUndecided);
  EXPECT_NEAR(pixel_aspect(evidence).ratio, 1.03, 1e-12);
  BoardShape shape;
  shape.lens.fx_px = shape.lens.fy_px = 500;
  shape.stretch = 0.03, shape.stretch_sd = 0.002, shape.is_stretched = true;
  evidence.shape = shape;
  EXPECT_EQ(pixel_aspect(evidence).cause, AspectCause::kBoard);
  shape.lens.fx_px = 515;
  shape.stretch = 0.001, shape.is_stretched = false;
  evidence.shape = shape;
  EXPECT_EQ(pixel_aspect(evidence).cause, AspectCause::kImage);
  evidence.shape->stretch_sd = 0.02;
  EXPECT_EQ(pixel_aspect(evidence).cause, AspectCause::kUndecided);
  evidence.fit.covariance *= 100;
  EXPECT_EQ(pixel_aspect(evidence).cause, AspectCause::kNone);
}

}  // namespace
}  // namespace alltact
