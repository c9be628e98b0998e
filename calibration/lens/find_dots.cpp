// Dot grids: blobs put in order by OpenCV, each then measured by the grey it holds.
#include "calibration/lens/find_board.h"
#include "core/numerics/median.h"

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

bool find_grid(const cv::Mat& dark_dots, const Board& board, std::vector<cv::Point2f>& centres) {
  cv::SimpleBlobDetector::Params how;
  how.minArea = 12;
  // A dot that is as wide as its share of a picture filled by the board.
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

/// Centroid of the darkness around a place, background taken off; each pixel counts as the part of
/// it that is dark, so that the rim gives fractions of a pixel.
std::optional<Dot> measured(const cv::Mat& grey, cv::Point2f start, int reach) {
  const cv::Rect around(static_cast<int>(std::lround(start.x)) - reach,
                        static_cast<int>(std::lround(start.y)) - reach,
                        2 * reach + 1,
                        2 * reach + 1);
  if ((around & cv::Rect({0, 0}, grey.size())) != around) return std::nullopt;
  std::vector<double> rim;
  const auto radius_at = [&](int u, int v) { return std::hypot(u - start.x, v - start.y); };
  for (int v = around.y; v < around.br().y; ++v)
    for (int u = around.x; u < around.br().x; ++u)
      if (const double r = radius_at(u, v); r <= reach && r > reach - 1.5)
        rim.push_back(grey.at<std::uint8_t>(v, u));
  const double background = upper_median(rim);
  std::vector<double> core;
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u)
      core.push_back(grey.at<std::uint8_t>(static_cast<int>(std::lround(start.y)) + v,
                                           static_cast<int>(std::lround(start.x)) + u));
  const double contrast = background - upper_median(core);
  if (!(contrast > 10)) return std::nullopt;
  Dot dot{Eigen::Vector2d::Zero(), 0};
  for (int v = around.y; v < around.br().y; ++v)
    for (int u = around.x; u < around.br().x; ++u) {
      if (radius_at(u, v) > reach) continue;
      // What differs little from the background is its noise, not part of the dot.
      const double share = (background - grey.at<std::uint8_t>(v, u)) / contrast;
      if (share < 0.1) continue;
      const double part = std::min(share, 1.0);
      dot.centre += part * Eigen::Vector2d(u, v);
      dot.area_px2 += part;
    }
  if (!(dot.area_px2 > 4)) return std::nullopt;
  dot.centre /= dot.area_px2;
  return dot;
}

/// Dot diameter over distance, from areas: the ratio of two areas is the same in every affine view.
double dot_part_of(const std::vector<Dot>& dots, const Board& board) {
  std::vector<double> parts;
  for (int row = 0; row + 1 < board.rows; ++row)
    for (int column = 0; column + 1 < board.columns; ++column) {
      const auto at = static_cast<std::size_t>(row * board.columns + column);
      const Eigen::Vector2d right = dots[at + 1].centre - dots[at].centre;
      const Eigen::Vector2d below =
          dots[at + static_cast<std::size_t>(board.columns)].centre - dots[at].centre;
      const double cell = std::abs(right.x() * below.y() - right.y() * below.x());
      parts.push_back(std::sqrt(4 / M_PI * dots[at].area_px2 / cell));
    }
  return upper_median(parts);
}

}  // namespace

Result<BoardView> find_dots(const cv::Mat& grey, const Board& board) {
  std::vector<cv::Point2f> centres;
  cv::Mat dark_dots = grey;
  if (!find_grid(dark_dots, board, centres)) {
    cv::bitwise_not(grey, dark_dots);
    if (!find_grid(dark_dots, board, centres)) return no_board(grey, board, "dot grid");
  }
  std::vector<Eigen::Vector2d> places;
  for (const cv::Point2f& centre : centres) places.emplace_back(centre.x, centre.y);
  const int reach = std::max(3, static_cast<int>(half_spacing_px(places)));
  std::vector<Dot> dots;
  BoardView view;
  for (int i = 0; i < static_cast<int>(centres.size()); ++i) {
    const auto dot = measured(dark_dots, centres[static_cast<std::size_t>(i)], reach);
    if (!dot)
      return Error{"a dot of the grid lies at the picture's border or has no contrast",
                   "",
                   "the whole board in the picture, evenly lit"};
    dots.push_back(*dot);
    view.board_mm.emplace_back(
        board.square_mm * (i % board.columns), board.square_mm * (i / board.columns), 0.0);
    view.pixels.push_back(dot->centre);
  }
  view.dot_part = dot_part_of(dots, board);
  return view;
}

}  // namespace alltact
