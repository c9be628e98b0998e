#include "calibration/lens/lens_fit.h"

#include "calibration/lens/calibrate_lens.h"
#include "tests/support/boards.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using made::board_lens;
using made::board_scene;
using made::chessboard;

LensFit truth_of(const made::BoardScene& scene, const CameraParameters& lens) {
  LensFit fit;
  fit.lens = lens;
  fit.poses = scene.poses;
  return fit;
}

TEST(ViewCost, ProjectsAsTheCameraDoes) {
  std::mt19937 random(2);
  for (const CameraModel model : {CameraModel::kBrown, CameraModel::kFisheye}) {
    const Camera camera = Camera::create(board_lens(model)).value();
    const Eigen::VectorXd numbers = lens_numbers(camera.parameters());
    const auto scene = board_scene(camera, chessboard(), 5, 40, 0, random);
    for (std::size_t i = 0; i < scene.views.size(); ++i)
      for (std::size_t k = 0; k < scene.views[i].pixels.size(); ++k) {
        const auto seen =
            project_by(model, {numbers.data(), static_cast<std::size_t>(numbers.size())},
                       scene.poses[i](scene.views[i].board_mm[k]));
        ASSERT_TRUE(seen);
        EXPECT_LT((seen->pixel - scene.views[i].pixels[k]).norm(), 1e-10);
      }
  }
}

TEST(ViewCost, DerivativesAreThoseOfTheResiduals) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const CameraModel model : {CameraModel::kBrown, CameraModel::kFisheye}) {
    const Camera camera = Camera::create(board_lens(model)).value();
    for (int trial = 0; trial < 10; ++trial) {
      const auto scene = board_scene(camera, chessboard(4, 3, 6), 1, 50, 0.3, random);
      std::vector<double> weights;
      for (int i = 0; i < 12; ++i) weights.push_back(1 + 0.5 * unit(random));
      ViewCost::Units units;
      units.px = 640, units.mm = 11;
      units.board_middle_mm = {9, 6, 0}, units.board_half_mm = 10;
      const ViewCost cost(model, scene.views[0], weights, units);
      Eigen::VectorXd numbers = lens_numbers(camera.parameters());
      numbers.head<4>() /= units.px;
      Eigen::VectorXd pose(6), shape(4);
      pose << scene.poses[0].turn, scene.poses[0].shift_mm / units.mm;
      if (trial == 0) pose.head<3>() *= 1e-7;  // nearly no turn
      shape << 0.02, 0.03, -0.02, 0.01;
      std::array<Eigen::VectorXd*, 3> blocks{&numbers, &pose, &shape};
      const auto residuals = [&] {
        Eigen::VectorXd values(24);
        const double* at[] = {numbers.data(), pose.data(), shape.data()};
        EXPECT_TRUE(cost.Evaluate(at, values.data(), nullptr));
        return values;
      };
      for (std::size_t b = 0; b < 3; ++b) {
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> analytic(
            24, blocks[b]->size());
        double* jacobians[] = {nullptr, nullptr, nullptr};
        jacobians[b] = analytic.data();
        const double* at[] = {numbers.data(), pose.data(), shape.data()};
        Eigen::VectorXd ignored(24);
        ASSERT_TRUE(cost.Evaluate(at, ignored.data(), jacobians));
        for (int i = 0; i < blocks[b]->size(); ++i) {
          // Five places: what is left of the step's own error is below the residuals' roundings.
          constexpr double kStep = 2e-3;
          const double kept = (*blocks[b])[i];
          const auto moved = [&](double steps) {
            (*blocks[b])[i] = kept + steps * kStep;
            return residuals();
          };
          const Eigen::VectorXd numeric =
              (8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * kStep);
          (*blocks[b])[i] = kept;
          EXPECT_LT((numeric - analytic.col(i)).norm(), 1e-7 * (1 + numeric.norm()))
              << "block " << b << " number " << i;
        }
      }
    }
  }
}

TEST(LensFit, WithoutNoiseTheTruthComesBackFromNothing) {
  std::mt19937 random(4);
  for (const CameraModel model : {CameraModel::kBrown, CameraModel::kFisheye}) {
    const CameraParameters truth = board_lens(model);
    const Camera camera = Camera::create(truth).value();
    const auto scene = board_scene(camera, chessboard(), 12, 35, 0, random);
    LensSettings settings;
    settings.model = model;
    const auto found = calibrate_lens(scene.views, camera.size(), settings, {});
    ASSERT_TRUE(found) << found.error().sentence();
    const Eigen::VectorXd error = lens_numbers(found->fit.lens) - lens_numbers(truth);
    EXPECT_LT(error.head<4>().cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_LT(error.tail(error.size() - 4).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_EQ(found->used.size(), 12U);
  }
}

TEST(LensFit, ReportedCovarianceIsTrue) {
  constexpr int kRuns = 400;
  for (const CameraModel model : {CameraModel::kBrown, CameraModel::kFisheye}) {
    const CameraParameters truth = board_lens(model);
    const Camera camera = Camera::create(truth).value();
    const int coefficients = model == CameraModel::kFisheye ? 4 : 5;
    double sum = 0;
    int n = 0;
    for (int run = 0; run < kRuns; ++run) {
      std::mt19937 random(1000 + run);
      const auto scene = board_scene(camera, chessboard(7, 6, 3.5), 8, 35, 0.2, random);
      const auto fit = fit_lens(scene.views, truth_of(scene, truth), coefficients, {});
      ASSERT_TRUE(fit) << fit.error().sentence();
      const Eigen::VectorXd error = lens_numbers(fit->lens) - lens_numbers(truth);
      n = static_cast<int>(error.size());
      // Scaled, or the numbers' sizes spoil the solution.
      const Eigen::VectorXd scale = fit->covariance.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd scaled = scale.cwiseProduct(error);
      const Eigen::MatrixXd correlation = scale.asDiagonal() * fit->covariance * scale.asDiagonal();
      sum += scaled.dot(correlation.ldlt().solve(scaled)) / n;
    }
    const double nees = sum / kRuns;
    RecordProperty(model == CameraModel::kFisheye ? "fisheye" : "brown", std::to_string(nees));
    EXPECT_GT(nees, 0.85) << to_string(model);
    EXPECT_LT(nees, 1.15) << to_string(model);
  }
}

TEST(LensFit, MoreAndMoreTiltedBoardsTellTheFocalLengthAsWellAsTheStandardDeviationSays) {
  // Geometric mean of the standard deviation over drawn sets of boards, in percent of f: 9 x 7
  // corners, 0.2 px. Measured here; that it is true shows from the errors themselves.
  struct Row {
    int boards;
    double tilt_deg, percent;
  };
  const CameraParameters truth = board_lens();
  const Camera camera = Camera::create(truth).value();
  constexpr int kRuns = 24;
  double squares = 0;
  int errors = 0;
  for (const Row& row :
       {Row{5, 15, 1.0}, {5, 35, 0.29}, {10, 15, 0.54}, {10, 35, 0.165}, {20, 35, 0.108}}) {
    double sum = 0;
    for (int run = 0; run < kRuns; ++run) {
      std::mt19937 random(1000 * row.boards + 100 * static_cast<int>(row.tilt_deg) + run);
      const auto scene = board_scene(camera, chessboard(), row.boards, row.tilt_deg, 0.2, random);
      const auto fit = fit_lens(scene.views, truth_of(scene, truth), kAllCoefficients, {});
      ASSERT_TRUE(fit) << fit.error().sentence();
      sum += std::log(100 * fit->sd(0) / fit->lens.fx_px);
      squares += std::pow((fit->lens.fx_px - truth.fx_px) / fit->sd(0), 2);
      ++errors;
    }
    // The logarithm scatters by 0.35 at most between sets: three standard errors.
    EXPECT_NEAR(std::exp(sum / kRuns) / row.percent, 1.0, 3 * 0.35 / std::sqrt(kRuns))
        << row.boards << " boards, " << row.tilt_deg << " deg";
  }
  // The root mean square of n normal numbers scatters by 1 / sqrt(2 n).
  EXPECT_NEAR(std::sqrt(squares / errors), 1.0, 3 / std::sqrt(2.0 * errors));
}

TEST(LensFit, GrossErrorsAreFoundAndDoNoHarm) {
  std::mt19937 random(7);
  const CameraParameters truth = board_lens();
  const Camera camera = Camera::create(truth).value();
  auto scene = board_scene(camera, chessboard(), 12, 35, 0.15, random);
  scene.views[3].pixels[10].x() += 4;
  scene.views[5].pixels[20].y() -= 7;
  const auto fit = fit_lens(scene.views, truth_of(scene, truth), kAllCoefficients, {});
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->weights[3][10], 0);
  EXPECT_EQ(fit->weights[5][20], 0);
  EXPECT_NEAR(fit->sigma_px, 0.15, 0.01);
  EXPECT_LT(std::abs(fit->lens.fx_px - truth.fx_px), 4 * fit->sd(0));
}

TEST(LensFit, ViewsThatDoNotShowTheLensAreRefused) {
  std::mt19937 random(8);
  const Camera camera = Camera::create(board_lens()).value();
  const Board board = chessboard();
  std::vector<BoardView> views;
  LensFit start;
  start.lens = board_lens();
  for (int i = 0; i < 3; ++i) {  // all straight: distance and focal length are one
    BoardPose pose;
    pose.shift_mm = {-10.0 + i, -7.5 - i, 45.0};
    views.push_back(made::seen_by(camera, board, pose, 0.2, random).value());
    start.poses.push_back(pose);
  }
  start.lens.distortion.clear();
  const auto fit = fit_lens(views, start, 0, {});
  EXPECT_TRUE(!fit || fit->sd(0) > 0.02 * fit->lens.fx_px);
}

}  // namespace
}  // namespace alltact
