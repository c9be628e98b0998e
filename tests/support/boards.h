// Boards seen by a camera that is known: corners with noise, and whole pictures.
#pragma once

#include "calibration/lens/board.h"
#include "calibration/lens/lens_fit.h"
#include "core/camera/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace alltact::made {

/// 640 x 480, as bent as a webcam's.
inline CameraParameters board_lens(CameraModel model = CameraModel::kBrown) {
  CameraParameters p;
  p.model = model;
  p.width_px = 640, p.height_px = 480;
  p.cx_px = 325.3, p.cy_px = 236.8;
  if (model == CameraModel::kFisheye) {
    p.fx_px = 285.2, p.fy_px = 284.6;
    p.distortion = {0.012, -0.006, 0.003, -0.0006};
  } else {
    p.fx_px = 521.4, p.fy_px = 522.9;
    p.distortion = {-0.21, 0.07, 0.0008, -0.0005, -0.008};
  }
  return p;
}

inline Board chessboard(int columns = 9, int rows = 7, double square_mm = 2.5) {
  Board board;
  board.columns = columns, board.rows = rows, board.square_mm = square_mm;
  return board;
}

inline std::vector<Eigen::Vector3d> places(const Board& board) {
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < board.point_count(); ++i) result.push_back(board.point_mm(i));
  return result;
}

/// The corner that lies opposite the board's first one.
inline Eigen::Vector3d far_corner_mm(const Board& board) {
  Eigen::Vector3d far = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : places(board)) far = far.cwiseMax(place);
  return far;
}

/// Tilted up to `tilt_deg` in any direction, rolled a little, somewhere in the picture, its middle
/// `distance` board diagonals away.
template <class Random>
BoardPose random_pose(const Board& board, double tilt_deg, double distance, Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double way = M_PI * unit(random);
  const double tilt = tilt_deg * M_PI / 180 * std::sqrt(std::abs(unit(random)));
  const Eigen::AngleAxisd roll(0.3 * unit(random), Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd lean(tilt, Eigen::Vector3d(std::cos(way), std::sin(way), 0));
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(lean.toRotationMatrix() * roll.toRotationMatrix()));
  const Eigen::Vector3d far = far_corner_mm(board), middle = 0.5 * far;
  const double z = far.norm() * distance * (1 + 0.15 * unit(random));
  BoardPose pose;
  pose.turn = turn.angle() * turn.axis();
  pose.shift_mm =
      Eigen::Vector3d(0.28 * z * unit(random), 0.2 * z * unit(random), z) - turn * middle;
  return pose;
}

/// nullopt when a corner lies outside the picture.
template <class Random>
std::optional<BoardView> seen_by(const Camera& camera, const Board& board, const BoardPose& pose,
                                 double noise_px, Random& random) {
  std::normal_distribution<double> noise(0, 1);
  BoardView view;
  view.board_mm = places(board);
  view.edge_px = 1.5;
  for (const Eigen::Vector3d& place : view.board_mm) {
    const auto pixel = camera.project(pose(place));
    if (!pixel || pixel->minCoeff() < 0 || pixel->x() > camera.size().width - 1 ||
        pixel->y() > camera.size().height - 1)
      return std::nullopt;
    view.pixels.emplace_back(*pixel + noise_px * Eigen::Vector2d(noise(random), noise(random)));
  }
  return view;
}

struct BoardScene {
  std::vector<BoardView> views;
  std::vector<BoardPose> poses;
};

template <class Random>
BoardScene board_scene(const Camera& camera, const Board& board, int count, double tilt_deg,
                       double noise_px, Random& random) {
  BoardScene scene;
  const double distance = camera.parameters().model == CameraModel::kFisheye ? 0.9 : 1.4;
  while (static_cast<int>(scene.views.size()) < count) {
    const BoardPose pose = random_pose(board, tilt_deg, distance, random);
    auto view = seen_by(camera, board, pose, noise_px, random);
    if (!view) continue;
    view->name = "view_" + std::to_string(100 + scene.views.size());
    scene.views.push_back(std::move(*view));
    scene.poses.push_back(pose);
  }
  return scene;
}

/// Paints boards by the area that ink covers of each pixel.
class BoardPainter {
 public:
  explicit BoardPainter(const Camera& camera) : size_(camera.size()) {
    for (int v = 0; v <= size_.height; ++v)
      for (int u = 0; u <= size_.width; ++u) {
        const auto ray = camera.unproject({u - 0.5, v - 0.5});
        corners_.push_back(ray ? ray->direction : Eigen::Vector3d(0, 0, -1));
      }
  }

  /// `ink(x_mm, y_mm)`: brightness of the board there, 0 to 255; slightly blurred, with noise.
  template <class Ink>
  [[nodiscard]] cv::Mat paint(const BoardPose& pose, const Ink& ink, std::uint64_t seed,
                              double noise_sd = 1.5) const {
    const Eigen::Matrix3d to_board = pose.rotation().transpose();
    const Eigen::Vector3d from = -(to_board * pose.shift_mm);
    const auto seen = [&](const Eigen::Vector3d& ray) {
      const Eigen::Vector3d way = to_board * ray;
      const double far = -from.z() / way.z();
      return far > 0 ? ink(from.x() + far * way.x(), from.y() + far * way.y()) : 60.0;
    };
    cv::Mat image(size_, CV_32F);
    for (int v = 0; v < size_.height; ++v)
      for (int u = 0; u < size_.width; ++u)
        image.at<float>(v, u) = static_cast<float>(mean_in(u, v, seen));
    cv::GaussianBlur(image, image, {5, 5}, 0.7);
    cv::Mat noise(size_, CV_32F);
    cv::RNG random(seed);
    random.fill(noise, cv::RNG::NORMAL, 0, noise_sd);
    cv::Mat grey;
    cv::Mat(image + noise).convertTo(grey, CV_8U);
    return grey;
  }

 private:
  /// Rays within a pixel lie between those of its corners. Where those see one brightness, all do.
  template <class Seen>
  [[nodiscard]] double mean_in(int u, int v, const Seen& seen) const {
    const auto at = static_cast<std::size_t>(v * (size_.width + 1) + u);
    const auto below = at + static_cast<std::size_t>(size_.width) + 1;
    const Eigen::Vector3d &a = corners_[at], &b = corners_[at + 1], &c = corners_[below],
                          &d = corners_[below + 1];
    const std::array<double, 4> levels{seen(a), seen(b), seen(c), seen(d)};
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    if (*high - *low < 5) return 0.25 * (levels[0] + levels[1] + levels[2] + levels[3]);
    constexpr int kParts = 8;
    double sum = 0;
    for (int j = 0; j < kParts; ++j)
      for (int i = 0; i < kParts; ++i) {
        const double x = (i + 0.5) / kParts, y = (j + 0.5) / kParts;
        sum += seen((1 - y) * ((1 - x) * a + x * b) + y * ((1 - x) * c + x * d));
      }
    return sum / (kParts * kParts);
  }

  cv::Size size_;
  std::vector<Eigen::Vector3d> corners_;  // of the pixels
};

/// Squares with the first inner corner at (0, 0), and a white border.
inline double chessboard_ink(const Board& board, double x_mm, double y_mm) {
  const double x = x_mm / board.square_mm, y = y_mm / board.square_mm;
  if (x < -2 || y < -2 || x > board.columns + 1 || y > board.rows + 1) return 60;
  if (x < -1 || y < -1 || x > board.columns || y > board.rows) return 200;
  const int parity = static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y));
  return parity % 2 == 0 ? 25 : 200;
}

inline double dots_ink(const Board& board, double dot_part, double x_mm, double y_mm) {
  const double x = x_mm / board.square_mm, y = y_mm / board.square_mm;
  if (x < -1 || y < -1 || x > board.columns || y > board.rows) return 60;
  const double du = x - std::round(x), dv = y - std::round(y);
  const bool is_dot = std::hypot(du, dv) < 0.5 * dot_part && std::round(x) >= 0 &&
                      std::round(y) >= 0 && std::round(x) < board.columns &&
                      std::round(y) < board.rows;
  return is_dot ? 25 : 200;
}

}  // namespace alltact::made
