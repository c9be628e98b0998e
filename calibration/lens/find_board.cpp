#include "calibration/lens/find_board.h"

#include "core/grey_range.h"
#include "core/numerics/median.h"

#include <fmt/format.h>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kFewestCorners = 6;

BoardView full_view(const Board& board, const std::vector<cv::Point2f>& corners) {
  BoardView view;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    view.board_mm.push_back(board.point_mm(i));
    view.pixels.emplace_back(corners[static_cast<std::size_t>(i)].x,
                             corners[static_cast<std::size_t>(i)].y);
  }
  return view;
}

constexpr double kHalfSpacing = 0.5;

/// Half windows for the refinement of each corner, at most `reach` of the distance to the next
/// corner. On a chessboard that is up to the middle of the shortest edge that meets in it, where
/// the next corner's own edges begin to interfere. A longer edge gives a more precise position, but
/// a lens bends it, which kLongest bounds.
std::vector<int> windows_px(const std::vector<cv::Point2f>& corners, double reach) {
  constexpr int kShortest = 2, kLongest = 10;
  std::vector<int> windows;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    double nearest = kLongest / reach;
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (k != i) nearest = std::min(nearest, cv::norm(corners[i] - corners[k]));
    windows.push_back(std::max(kShortest, static_cast<int>(reach * nearest)));
  }
  return windows;
}

void refine(const cv::Mat& grey, std::vector<cv::Point2f>& corners, double reach) {
  const std::vector<int> windows = windows_px(corners, reach);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::vector<cv::Point2f> one{corners[i]};
    const cv::Size window(windows[i], windows[i]);
    cv::cornerSubPix(
        grey, one, window, {-1, -1}, {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-4});
    corners[i] = one.front();
  }
}

bool find_corners(const cv::Mat& grey, cv::Size size, std::vector<cv::Point2f>& corners) {
  // The finder's own corners are precise to a tenth of a pixel on sharp images only.
  if (cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE) ||
      cv::findChessboardCornersSB(
          grey, size, corners, cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_NORMALIZE_IMAGE)) {
    refine(grey, corners, kHalfSpacing);
    return true;
  }
  // The classic finder detects some strongly bent boards that the other misses.
  constexpr int kClassic = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE |
                           cv::CALIB_CB_FILTER_QUADS | cv::CALIB_CB_FAST_CHECK;
  if (!cv::findChessboardCorners(grey, size, corners, kClassic)) return false;
  refine(grey, corners, kHalfSpacing);
  return true;
}

int dictionary_number(MarkerDictionary dictionary) {
  switch (dictionary) {
    case MarkerDictionary::k4x4:
      return cv::aruco::DICT_4X4_250;
    case MarkerDictionary::k5x5:
      return cv::aruco::DICT_5X5_250;
    case MarkerDictionary::k6x6:
      return cv::aruco::DICT_6X6_250;
    case MarkerDictionary::kOriginal:
      return cv::aruco::DICT_ARUCO_ORIGINAL;
  }
  return cv::aruco::DICT_4X4_250;
}

bool spans_a_plane(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : points)
    spread += (point - mean).head<2>() * (point - mean).head<2>().transpose();
  return spread.determinant() > 1e-3 * spread.trace() * spread.trace() / 4;
}

}  // namespace

Error no_board(const cv::Mat& grey, const Board& board, const Message& pattern) {
  cv::Scalar mean, sd;
  cv::meanStdDev(grey, mean, sd);
  const double white = static_cast<double>(cv::countNonZero(grey >= kClippedFrom)) /
                       static_cast<double>(grey.total());
  Error error{en::say("no {} with {} can be seen", pattern, board.words()), "", ""};
  if (sd[0] < 12) {
    error.what = en::clauses({error.what, en::say("the picture has hardly any contrast")});
    error.advice = en::say("more light, and the board in focus");
  } else if (white > 0.3) {
    error.what =
        en::clauses({error.what, en::say("a large part of the picture is white without detail")});
    error.advice = en::say("a shorter exposure");
  } else {
    error.advice =
        en::say("the whole board in the picture, with its white border, sharp and evenly lit");
  }
  return error;
}

double half_spacing_px(const std::vector<Eigen::Vector2d>& pixels) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (std::size_t k = i + 1; k < pixels.size(); ++k)
      nearest = std::min(nearest, (pixels[i] - pixels[k]).squaredNorm());
  return 0.5 * std::sqrt(nearest);
}

double edge_width_px(const cv::Mat& grey, const std::vector<Eigen::Vector2d>& pixels) {
  const int reach = std::clamp(static_cast<int>(1.2 * half_spacing_px(pixels)), 3, 20);
  std::vector<double> widths;
  for (const Eigen::Vector2d& pixel : pixels) {
    const cv::Rect around(static_cast<int>(pixel.x()) - reach,
                          static_cast<int>(pixel.y()) - reach,
                          2 * reach + 1,
                          2 * reach + 1);
    const cv::Rect inside = around & cv::Rect({0, 0}, grey.size());
    if (inside != around) continue;
    double low = 0, high = 0, steepest = 0;
    cv::minMaxLoc(grey(inside), &low, &high);
    cv::Mat du, dv, slope;
    cv::Scharr(grey(inside), du, CV_32F, 1, 0, 1.0 / 32);
    cv::Scharr(grey(inside), dv, CV_32F, 0, 1, 1.0 / 32);
    cv::magnitude(du, dv, slope);
    cv::minMaxLoc(slope, nullptr, &steepest);
    if (steepest > 0) widths.push_back((high - low) / steepest);
  }
  return widths.empty() ? 0 : upper_median(widths);
}

Result<BoardView> find_chessboard(const cv::Mat& grey, const Board& board) {
  std::vector<cv::Point2f> corners;
  if (!find_corners(grey, {board.columns, board.rows}, corners))
    return no_board(grey, board, en::say("chessboard"));
  return full_view(board, corners);
}

Result<BoardView> find_charuco(const cv::Mat& grey, const Board& board) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(dictionary_number(board.dictionary));
  const auto square = static_cast<float>(board.square_mm);
  const auto charuco =
      cv::aruco::CharucoBoard::create(board.columns + 1,
                                      board.rows + 1,
                                      square,
                                      square * static_cast<float>(board.marker_part),
                                      dictionary);
  std::vector<std::vector<cv::Point2f>> markers;
  std::vector<int> marker_ids;
  cv::aruco::detectMarkers(grey, dictionary, markers, marker_ids);
  if (markers.empty()) {
    Error error = no_board(grey, board, en::say("ChArUco board"));
    error.what = en::clauses({error.what, en::say("not one of its markers")});
    return error;
  }
  std::vector<cv::Point2f> corners;
  std::vector<int> ids;
  cv::aruco::interpolateCornersCharuco(markers, marker_ids, grey, charuco, corners, ids);
  if (static_cast<int>(corners.size()) < kFewestCorners)
    return Error{en::say("only {} of the ChArUco board's corners can be seen, {} are needed",
                         corners.size(),
                         kFewestCorners),
                 "",
                 en::say("more of the board in the picture, sharp and evenly lit")};
  // Markers fill the squares around a corner, so the window ends before them.
  refine(grey, corners, 0.5 * (1 - board.marker_part));
  BoardView view;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Point3f& corner_mm = charuco->chessboardCorners[static_cast<std::size_t>(ids[i])];
    view.board_mm.emplace_back(corner_mm.x, corner_mm.y, 0.0);
    view.pixels.emplace_back(corners[i].x, corners[i].y);
  }
  if (!spans_a_plane(view.board_mm))
    return Error{en::say("only corners in one line of the ChArUco board can be seen"),
                 "",
                 en::say("more of the board in the picture")};
  return view;
}

std::string other_size_found(const cv::Mat& grey, const Board& board) {
  if (board.pattern != BoardPattern::kChessboard) return {};
  for (const int columns : {board.columns, board.columns - 1, board.columns + 1})
    for (const int rows : {board.rows, board.rows - 1, board.rows + 1}) {
      if (columns < 3 || rows < 3 || (columns == board.columns && rows == board.rows)) continue;
      std::vector<cv::Point2f> corners;
      try {
        if (cv::findChessboardCornersSB(grey, {columns, rows}, corners))
          return fmt::format("{} x {}", columns, rows);
      } catch (const cv::Exception&) {
        return {};
      }
    }
  return {};
}

}  // namespace alltact
