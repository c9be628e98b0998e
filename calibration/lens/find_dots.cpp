// Dot grids: OpenCV orders the blobs, then each dot is measured by its grey values.
#include "calibration/lens/find_board.h"
#include "core/numerics/median.h"

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

bool find_grid(const cv::Mat& dark_dots, const Board& board, std::vector<cv::Point2f>& centres) {
  cv::SimpleBlobDetector::Params how;
  how.minArea = 12;
  // The largest dot of a board that fills the image.
  how.maxArea = static_cast<float>(dark_dots.total()) /
                static_cast<float>(std::min(board.columns * board.rows, 100));
  how.minDistBetweenBlobs = 4;
  how.filterByConvexity = false;
  how.filterByInertia = false;
  how.filterByCircularity = true;
  how.minCircularity = 0.4F;  // a tilted dot is an ellipse
  return cv::findCirclesGrid(dark_dots,
                             {board.columns, board.rows},
                             centres,
                             cv::CALIB_CB_SYMMETRIC_GRID,
                             cv::SimpleBlobDetector::create(how));
}

struct Dot {
  Eigen::Vector2d centre;
  double area_px2 = 0;
};

/// Brightness of the paper around a dot, as a plane. Illumination of a board is uneven, and an even
/// paper level would shift a dot towards its darker side.
class Paper {
 public:
  /// From the pixels of a ring; neighbouring dots that reach into it are left out.
  Paper(const cv::Mat& grey, const std::vector<cv::Point>& ring, cv::Point2f middle)
      : middle_(middle) {
    std::vector<double> levels;
    for (const cv::Point& at : ring) levels.push_back(grey.at<std::uint8_t>(at));
    const double median = upper_median(levels);
    plane_ = {median, 0, 0};
    for (double& level : levels) level = std::abs(level - median);
    double max_off = 3 * kSdOfMedian * std::max(upper_median(levels), 1.0);
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
      Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
      Eigen::Vector3d pull = Eigen::Vector3d::Zero();
      double square = 0, used = 0;
      for (const cv::Point& at : ring) {
        const Eigen::Vector3d row = row_of(at.x, at.y);
        const double level = grey.at<std::uint8_t>(at), off = level - row.dot(plane_);
        if (std::abs(off) > max_off) continue;
        information += row * row.transpose();
        pull += row * level;
        square += off * off, ++used;
      }
      const Eigen::LDLT<Eigen::Matrix3d> solver(information);
      if (used < 8 || !solver.isPositive() || !(solver.rcond() > 1e-9)) return;
      plane_ = solver.solve(pull);
      max_off = 3 * std::max(1.0, std::sqrt(square / used));
    }
  }
  [[nodiscard]] double level(int u, int v) const { return row_of(u, v).dot(plane_); }

 private:
  static constexpr double kSdOfMedian = 1.4826;
  [[nodiscard]] Eigen::Vector3d row_of(int u, int v) const {
    return {1.0, u - static_cast<double>(middle_.x), v - static_cast<double>(middle_.y)};
  }

  cv::Point2f middle_;
  Eigen::Vector3d plane_;
};

/// The pixels of one dot: an ellipse up to the midpoints to the neighbouring dots, by the board's
/// tilt. `ring` has its outermost pixels, which show paper.
struct Surroundings {
  std::vector<cv::Point> disc, ring;
  Surroundings(cv::Point2f middle, const Eigen::Matrix2d& spacing);
};

Surroundings::Surroundings(cv::Point2f middle, const Eigen::Matrix2d& spacing) {
  const Eigen::Matrix2d to_board = spacing.inverse();
  const double ring_px = 1.5, shorter = spacing.colwise().norm().minCoeff();
  const double inner = 0.5 - ring_px / shorter;
  const int reach = static_cast<int>(0.5 * spacing.norm()) + 1;
  const int u0 = static_cast<int>(std::lround(middle.x)),
            v0 = static_cast<int>(std::lround(middle.y));
  for (int v = v0 - reach; v <= v0 + reach; ++v)
    for (int u = u0 - reach; u <= u0 + reach; ++u) {
      const Eigen::Vector2d off(u - static_cast<double>(middle.x),
                                v - static_cast<double>(middle.y));
      const double away = (to_board * off).norm();
      if (away > 0.5) continue;
      disc.emplace_back(u, v);
      if (away > inner) ring.emplace_back(u, v);
    }
}

/// Centroid of the darkness around a pixel, relative to the paper there. Each pixel counts by its
/// dark fraction, so that the rim gives fractions of a pixel. `spacing`: to the next dot in the row
/// and in the column, px.
std::optional<Dot> measured(const cv::Mat& grey,
                            cv::Point2f start,
                            const Eigen::Matrix2d& spacing) {
  const cv::Rect image_rect({0, 0}, grey.size());
  const cv::Point middle(static_cast<int>(std::lround(start.x)),
                         static_cast<int>(std::lround(start.y)));
  if (!(std::abs(spacing.determinant()) > 36)) return std::nullopt;  // 6 px apart
  const auto [disc, ring] = Surroundings(start, spacing);
  for (const cv::Point& at : disc)
    if (!image_rect.contains(at)) return std::nullopt;
  const Paper paper(grey, ring, start);
  const auto darkness = [&](int u, int v) {
    return 1 - grey.at<std::uint8_t>(v, u) / std::max(paper.level(u, v), 1.0);
  };
  std::vector<double> core;
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) core.push_back(darkness(middle.x + u, middle.y + v));
  const double contrast = upper_median(core);
  if (!(contrast * paper.level(middle.x, middle.y) > 10)) return std::nullopt;
  Dot dot{Eigen::Vector2d::Zero(), 0};
  for (const cv::Point& at : disc) {
    // Small differences from the paper are noise, not part of the dot.
    const double share = darkness(at.x, at.y) / contrast;
    if (share < 0.1) continue;
    const double part = std::min(share, 1.0);
    dot.centre += part * Eigen::Vector2d(at.x, at.y);
    dot.area_px2 += part;
  }
  if (!(dot.area_px2 > 4)) return std::nullopt;
  dot.centre /= dot.area_px2;
  return dot;
}

/// Vectors from a grid point to the next in its row and in its column, px.
Eigen::Matrix2d spacing_at(const std::vector<cv::Point2f>& centres, const Board& board, int i) {
  const auto between = [&](int at, int count, int step) -> Eigen::Vector2d {
    const int after = at + 1 < count ? step : 0, before = at > 0 ? step : 0;
    const cv::Point2f step_px = centres[static_cast<std::size_t>(i + after)] -
                                centres[static_cast<std::size_t>(i - before)];
    return Eigen::Vector2d(step_px.x, step_px.y) / (after > 0 && before > 0 ? 2.0 : 1.0);
  };
  Eigen::Matrix2d spacing;
  spacing.col(0) = between(i % board.columns, board.columns, 1);
  spacing.col(1) = between(i / board.columns, board.rows, board.columns);
  return spacing;
}

}  // namespace

Result<BoardView> find_dots(const cv::Mat& grey, const Board& board) {
  std::vector<cv::Point2f> centres;
  cv::Mat dark_dots = grey;
  if (!find_grid(dark_dots, board, centres)) {
    cv::bitwise_not(grey, dark_dots);
    if (!find_grid(dark_dots, board, centres)) return no_board(grey, board, en::say("dot grid"));
  }
  BoardView view;
  std::vector<double> parts;
  for (int i = 0; i < static_cast<int>(centres.size()); ++i) {
    const Eigen::Matrix2d spacing = spacing_at(centres, board, i);
    const auto dot = measured(dark_dots, centres[static_cast<std::size_t>(i)], spacing);
    if (!dot)
      return Error{en::say("a dot of the grid lies at the picture's border or has no contrast"),
                   "",
                   en::say("the whole board in the picture, evenly lit")};
    // The ratio of two areas is the same in every affine view.
    parts.push_back(std::sqrt(4 / M_PI * dot->area_px2 / std::abs(spacing.determinant())));
    view.board_mm.push_back(board.point_mm(i));
    view.pixels.push_back(dot->centre);
  }
  view.dot_part = upper_median(parts);
  return view;
}

}  // namespace alltact
