// Boards from pictures: what finding them costs, and whether the lens that comes out is as good as
// it says. ALLTACT_NEES_RUNS=100 makes as many runs as a figure needs.
#include "calibration/lens/calibrate_lens.h"
#include "tests/support/boards.h"
#include "tests/support/slow_run.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using made::board_lens;
using made::BoardPainter;

constexpr double kDotPart = 0.5;

int runs_wanted(int usually) {
  const char* text = std::getenv("ALLTACT_NEES_RUNS");
  return text != nullptr ? std::max(10, std::atoi(text)) : usually;
}

Board board_of(BoardPattern pattern) {
  Board board = made::chessboard(8, 6, 4);
  board.pattern = pattern;
  return board;
}

/// Painted as the pattern is. `uneven`: by which part the light grows from the board's middle to
/// its right edge.
cv::Mat picture_of(const BoardPainter& painter, const Board& board, const BoardPose& pose,
                   std::uint64_t seed, double uneven = 0) {
  const auto ink = [&](double x, double y) {
    const double light = 1 + uneven * (x - 14) / 14;
    return light * (board.pattern == BoardPattern::kDots ? made::dots_ink(board, kDotPart, x, y)
                                                         : made::chessboard_ink(board, x, y));
  };
  return painter.paint(pose, ink, seed);
}

/// The found places in the order in which the scene has them.
std::vector<Eigen::Vector2d> in_order(const std::vector<Eigen::Vector2d>& found,
                                      const std::vector<Eigen::Vector2d>& truth) {
  std::vector<Eigen::Vector2d> ordered;
  for (const Eigen::Vector2d& place : truth)
    ordered.push_back(
        *std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
          return (a - place).squaredNorm() < (b - place).squaredNorm();
        }));
  return ordered;
}

/// Mean and spread of the errors of places in pictures, px.
struct PlaceErrors {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double squares = 0, count = 0;
  void add(const Eigen::Vector2d& error) { sum += error, squares += error.squaredNorm(), ++count; }
  [[nodiscard]] Eigen::Vector2d mean() const { return sum / count; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / count / 2); }  // a coordinate's
};

struct Figures {
  double sum = 0, squares = 0;
  int count = 0;
  [[nodiscard]] double nees() const { return sum / count; }
  [[nodiscard]] double sd() const {
    return std::sqrt(std::max(0.0, squares / count - nees() * nees()) / count);
  }
};

/// Many lenses, each calibrated from pictures of boards in other places, with other noise.
Figures calibrated_often(BoardPattern pattern, int runs, PlaceErrors* places) {
  const CameraParameters truth = board_lens();
  const Camera camera = Camera::create(truth).value();
  const BoardPainter painter(camera);
  const Board board = board_of(pattern);
  Figures figures;
  for (int run = 0; run < runs; ++run) {
    std::mt19937 random(9000 + run);
    const auto scene = made::board_scene(camera, board, 8, 40, 0, random);
    std::vector<BoardView> views;
    for (std::size_t i = 0; i < scene.poses.size(); ++i) {
      auto view = find_board(picture_of(painter, board, scene.poses[i], 100 * run + i), board);
      if (!view) continue;  // a board at the picture's border
      view->name = scene.views[i].name;
      view->pixels = in_order(view->pixels, scene.views[i].pixels);
      const BoardView centred =
          pattern == BoardPattern::kDots
              ? without_dot_bias(*view, truth, scene.poses[i], 0.5 * kDotPart * board.square_mm)
              : *view;
      for (std::size_t k = 0; k < centred.pixels.size(); ++k)
        places->add(centred.pixels[k] - scene.views[i].pixels[k]);
      views.push_back(std::move(*view));
    }
    EXPECT_GE(views.size(), 5U);
    const auto found = calibrate_lens(views, camera.size(), {}, {});
    EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
    if (!found || !(found->fit.covariance.diagonal().minCoeff() > 0)) continue;
    const Eigen::VectorXd scale = found->fit.covariance.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd scaled =
        scale.cwiseProduct(lens_numbers(found->fit.lens) - lens_numbers(truth));
    const Eigen::MatrixXd correlation =
        scale.asDiagonal() * found->fit.covariance * scale.asDiagonal();
    const double one =
        scaled.dot(correlation.ldlt().solve(scaled)) / static_cast<double>(scaled.size());
    figures.sum += one, figures.squares += one * one, ++figures.count;
  }
  return figures;
}

TEST(RenderedBoards, ALensIsAsGoodAsItSays) {
  for (const BoardPattern pattern : {BoardPattern::kChessboard, BoardPattern::kDots}) {
    const int runs = runs_wanted(test::as_many_as(4, 12));
    PlaceErrors places;
    const Figures figures = calibrated_often(pattern, runs, &places);
    const char* name = pattern == BoardPattern::kDots ? "dots" : "chessboards";
    std::printf(
        "[ figures  ] %s: normalised squared error %.2f +- %.2f in %d runs; places off by "
        "%.4f px rms, on average by (%.4f, %.4f)\n",
        name, figures.nees(), figures.sd(), figures.count, places.rms(), places.mean().x(),
        places.mean().y());
    EXPECT_GE(figures.count, 0.9 * runs) << name;
    EXPECT_LT(places.mean().norm(), 0.002) << name;
    EXPECT_LT(places.rms(), pattern == BoardPattern::kDots ? 0.01 : 0.035) << name;
    // What few runs scatter by is allowed for.
    EXPECT_LT(figures.nees() - 2 * figures.sd(), 1.15) << name;
    EXPECT_GT(figures.nees() + 2 * figures.sd(), 0.85) << name;
  }
}

// A dot whose paper is taken for even is drawn towards its darker side.
TEST(RenderedBoards, UnevenLightDoesNotMoveDots) {
  const Camera camera = Camera::create(board_lens()).value();
  const BoardPainter painter(camera);
  const Board board = board_of(BoardPattern::kDots);
  std::mt19937 random(41);
  const auto scene = made::board_scene(camera, board, 6, 40, 0, random);
  PlaceErrors places;
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    auto view = find_board(picture_of(painter, board, scene.poses[i], i, 0.2), board);
    if (!view) continue;  // a board at the picture's border
    view->pixels = in_order(view->pixels, scene.views[i].pixels);
    const BoardView centred =
        without_dot_bias(*view, board_lens(), scene.poses[i], 0.5 * kDotPart * board.square_mm);
    for (std::size_t k = 0; k < centred.pixels.size(); ++k)
      places.add(centred.pixels[k] - scene.views[i].pixels[k]);
  }
  ASSERT_GE(places.count, 3 * 48);
  std::printf("[ figures  ] dots, 40 %% more light on one side: off by %.4f px rms, mean %.4f\n",
              places.rms(), places.mean().norm());
  EXPECT_LT(places.mean().norm(), 0.004);
  EXPECT_LT(places.rms(), 0.012);
}

double least_distance(const std::vector<Eigen::Vector2d>& pixels, std::size_t i) {
  double least = 1e9;
  for (std::size_t k = 0; k < pixels.size(); ++k)
    if (k != i) least = std::min(least, (pixels[i] - pixels[k]).norm());
  return least;
}

// The window in which a corner is looked for must not say where it is found. Ours ends where the
// next corner begins to pull; smaller ones are noisier, larger ones go astray.
TEST(RenderedBoards, TheCornersWindowDoesNotMoveThem) {
  const Camera camera = Camera::create(board_lens()).value();
  const BoardPainter painter(camera);
  const Board board = board_of(BoardPattern::kChessboard);
  std::mt19937 random(43);
  const auto scene = made::board_scene(camera, board, 10, 40, 0, random);
  constexpr std::array kParts{0.15, 0.25, 0.35, 0.5, 0.6};
  std::array<PlaceErrors, kParts.size()> others;
  PlaceErrors ours;
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    const cv::Mat image = picture_of(painter, board, scene.poses[i], 70 + i);
    const auto view = find_board(image, board);
    ASSERT_TRUE(view) << view.error().sentence();
    const auto& truth = scene.views[i].pixels;
    const auto found = in_order(view->pixels, truth);
    for (std::size_t k = 0; k < truth.size(); ++k) {
      ours.add(found[k] - truth[k]);
      for (std::size_t p = 0; p < kParts.size(); ++p) {
        std::vector<cv::Point2f> corner{
            cv::Point2f(static_cast<float>(found[k].x()), static_cast<float>(found[k].y()))};
        const int half = std::max(2, static_cast<int>(kParts[p] * least_distance(truth, k)));
        cv::cornerSubPix(image, corner, {half, half}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-4});
        others[p].add(Eigen::Vector2d(corner[0].x, corner[0].y) - truth[k]);
      }
    }
  }
  double best = 1e9;
  for (std::size_t p = 0; p < kParts.size(); ++p) {
    std::printf("[ figures  ] corners, half window %.2f of the distance: rms %.4f px, mean %.4f\n",
                kParts[p], others[p].rms(), others[p].mean().norm());
    EXPECT_LT(others[p].mean().norm(), 0.006) << kParts[p];
    best = std::min(best, others[p].rms());
  }
  std::printf("[ figures  ] corners, ours: rms %.4f px, mean %.4f\n", ours.rms(),
              ours.mean().norm());
  EXPECT_LT(ours.mean().norm(), 0.004);
  EXPECT_LT(ours.rms(), 1.4 * best);
}

}  // namespace
}  // namespace alltact
