#include "calibration/lens/board.h"

#include "core/base/message.h"
#include "core/image/grey_range.h"
#include "core/numerics/median.h"

#include <array>
#include <charconv>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
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
    cv::cornerSubPix(grey, one, window, {-1, -1},
                     {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-4});
    corners[i] = one.front();
  }
}

bool find_corners(const cv::Mat& grey, cv::Size size, std::vector<cv::Point2f>& corners) {
  // The finder's own corners are precise to a tenth of a pixel on sharp images only.
  if (cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE) ||
      cv::findChessboardCornersSB(grey, size, corners,
                                  cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_NORMALIZE_IMAGE)) {
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
  constexpr std::array kNumbers{cv::aruco::DICT_4X4_250, cv::aruco::DICT_5X5_250,
                                cv::aruco::DICT_6X6_250, cv::aruco::DICT_ARUCO_ORIGINAL};
  return kNumbers.at(static_cast<std::size_t>(dictionary) - 1);
}

bool spans_a_plane(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : points)
    spread += (point - mean).head<2>() * (point - mean).head<2>().transpose();
  return spread.determinant() > 1e-3 * spread.trace() * spread.trace() / 4;
}

/// "no ... can be seen", with the reason as far as the image shows it.
Error no_board(const cv::Mat& grey, const Board& board, const Message& pattern) {
  cv::Scalar mean, sd;
  cv::meanStdDev(grey, mean, sd);
  const double white = static_cast<double>(cv::countNonZero(grey >= kClippedFrom)) /
                       static_cast<double>(grey.total());
  Error error{en::say("no {} with {} is visible", pattern, board.words()), "", ""};
  if (sd[0] < 12) {
    error.what = en::clauses({error.what, en::say("the image has hardly any contrast")});
    error.advice = en::say("more light, and the board in focus");
  } else if (white > 0.3) {
    error.what =
        en::clauses({error.what, en::say("a large part of the image is white without detail")});
    error.advice = en::say("a shorter exposure");
  } else {
    error.advice =
        en::say("the entire board in the image, with its white border, sharp and evenly lit");
  }
  return error;
}

/// Half the distance of the two nearest of these pixels.
double half_spacing_px(const std::vector<Eigen::Vector2d>& pixels) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (std::size_t k = i + 1; k < pixels.size(); ++k)
      nearest = std::min(nearest, (pixels[i] - pixels[k]).squaredNorm());
  return 0.5 * std::sqrt(nearest);
}

/// Median width of the edges around these pixels: contrast over the steepest slope. A sharp image
/// has about 1 to 2.
double edge_width_px(const cv::Mat& grey, const std::vector<Eigen::Vector2d>& pixels) {
  const int reach = std::clamp(static_cast<int>(1.2 * half_spacing_px(pixels)), 3, 20);
  std::vector<double> widths;
  for (const Eigen::Vector2d& pixel : pixels) {
    const cv::Rect around(static_cast<int>(pixel.x()) - reach, static_cast<int>(pixel.y()) - reach,
                          2 * reach + 1, 2 * reach + 1);
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
      cv::aruco::CharucoBoard::create(board.columns + 1, board.rows + 1, square,
                                      square * static_cast<float>(board.marker_part), dictionary);
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
    return Error{en::say("only {} of the ChArUco board's corners are visible, {} are needed",
                         corners.size(), kFewestCorners),
                 "", en::say("more of the board in the image, sharp and evenly lit")};
  // Markers fill the squares around a corner, so the window ends before them.
  refine(grey, corners, 0.5 * (1 - board.marker_part));
  BoardView view;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Point3f& corner_mm = charuco->chessboardCorners[static_cast<std::size_t>(ids[i])];
    view.board_mm.emplace_back(corner_mm.x, corner_mm.y, 0.0);
    view.pixels.emplace_back(corners[i].x, corners[i].y);
  }
  if (!spans_a_plane(view.board_mm))
    return Error{en::say("only corners in one line of the ChArUco board are visible"), "",
                 en::say("more of the board in the image")};
  return view;
}

// Dot grids: OpenCV orders the blobs, then each dot is measured by its grey values.

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
  return cv::findCirclesGrid(dark_dots, {board.columns, board.rows}, centres,
                             cv::CALIB_CB_SYMMETRIC_GRID, cv::SimpleBlobDetector::create(how));
}

struct Dot {
  Eigen::Vector2d centre;
  double area_px2 = 0;
};

/// A pixel in the coordinates of paper_around().
Eigen::Vector3d paper_row(int u, int v, cv::Point2f middle) {
  return {1.0, u - static_cast<double>(middle.x), v - static_cast<double>(middle.y)};
}

/// Brightness of the paper around a dot, as a plane. Illumination of a board is uneven, and an even
/// paper level would shift a dot towards its darker side. From the pixels of a ring; neighbouring
/// dots that reach into it are left out.
Eigen::Vector3d paper_around(const cv::Mat& grey, const std::vector<cv::Point>& ring,
                             cv::Point2f middle) {
  constexpr double kSdOfMedian = 1.4826;
  std::vector<double> levels;
  for (const cv::Point& at : ring) levels.push_back(grey.at<std::uint8_t>(at));
  const double median = upper_median(levels);
  Eigen::Vector3d plane(median, 0, 0);
  for (double& level : levels) level = std::abs(level - median);
  double max_off = 3 * kSdOfMedian * std::max(upper_median(levels), 1.0);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    double square = 0, used = 0;
    for (const cv::Point& at : ring) {
      const Eigen::Vector3d row = paper_row(at.x, at.y, middle);
      const double level = grey.at<std::uint8_t>(at), off = level - row.dot(plane);
      if (std::abs(off) > max_off) continue;
      information += row * row.transpose();
      pull += row * level;
      square += off * off, ++used;
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    if (used < 8 || !solver.isPositive() || !(solver.rcond() > 1e-9)) break;
    plane = solver.solve(pull);
    max_off = 3 * std::max(1.0, std::sqrt(square / used));
  }
  return plane;
}

/// The pixels of one dot: an ellipse up to the midpoints to the neighbouring dots, by the board's
/// tilt. `ring` receives its outermost pixels, which show paper.
std::vector<cv::Point> disc_around(cv::Point2f middle, const Eigen::Matrix2d& spacing,
                                   std::vector<cv::Point>* ring) {
  std::vector<cv::Point> disc;
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
      if (away > inner) ring->emplace_back(u, v);
    }
  return disc;
}

/// Centroid of the darkness around a pixel, relative to the paper there. Each pixel counts by its
/// dark fraction, so that the rim gives fractions of a pixel. `spacing`: to the next dot in the row
/// and in the column, px.
std::optional<Dot> measured(const cv::Mat& grey, cv::Point2f start,
                            const Eigen::Matrix2d& spacing) {
  const cv::Rect image_rect({0, 0}, grey.size());
  const cv::Point middle(static_cast<int>(std::lround(start.x)),
                         static_cast<int>(std::lround(start.y)));
  if (!(std::abs(spacing.determinant()) > 36)) return std::nullopt;  // 6 px apart
  std::vector<cv::Point> ring;
  const std::vector<cv::Point> disc = disc_around(start, spacing, &ring);
  for (const cv::Point& at : disc)
    if (!image_rect.contains(at)) return std::nullopt;
  const Eigen::Vector3d paper = paper_around(grey, ring, start);
  const auto paper_level = [&](int u, int v) { return paper_row(u, v, start).dot(paper); };
  const auto darkness = [&](int u, int v) {
    return 1 - grey.at<std::uint8_t>(v, u) / std::max(paper_level(u, v), 1.0);
  };
  std::vector<double> core;
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) core.push_back(darkness(middle.x + u, middle.y + v));
  const double contrast = upper_median(core);
  if (!(contrast * paper_level(middle.x, middle.y) > 10)) return std::nullopt;
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
    const cv::Point2f step_px = centres[static_cast<std::size_t>(std::ptrdiff_t{i} + after)] -
                                centres[static_cast<std::size_t>(i - before)];
    return Eigen::Vector2d(step_px.x, step_px.y) / (after > 0 && before > 0 ? 2.0 : 1.0);
  };
  Eigen::Matrix2d spacing;
  spacing.col(0) = between(i % board.columns, board.columns, 1);
  spacing.col(1) = between(i / board.columns, board.rows, board.columns);
  return spacing;
}

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
      return Error{en::say("a dot of the grid is at the image border or has no contrast"), "",
                   en::say("the entire board in the image, evenly lit")};
    // The ratio of two areas is the same in every affine view.
    parts.push_back(std::sqrt(4 / M_PI * dot->area_px2 / std::abs(spacing.determinant())));
    view.board_mm.push_back(board.point_mm(i));
    view.pixels.push_back(dot->centre);
  }
  view.dot_part = upper_median(parts);
  return view;
}

}  // namespace

Eigen::Vector3d Board::point_mm(int i) const {
  const int row = i / columns, column = i % columns;
  return {square_mm * column, square_mm * row, 0};
}

Message Board::words() const {
  const Message counted =
      pattern == BoardPattern::kDots ? en::say("dots") : en::say("inner corners");
  return en::say("{} x {} {}", columns, rows, counted);
}

Status set_board_size(Board& board, std::string_view text) {
  const auto side = [](std::string_view part) {
    int value = 0;
    const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), value);
    return status == std::errc{} && end == part.data() + part.size() ? value : 0;
  };
  const std::size_t cross = std::min(text.find('x'), text.size());
  const int columns = side(text.substr(0, cross));
  const int rows = cross < text.size() ? side(text.substr(cross + 1)) : 0;
  for (const int count : {columns, rows})
    if (count < 3 || count > 100)
      return Error{
          en::say("'{}' is not a board; it needs two counts from 3 to 100", printable(text)),
          std::string("--board"), en::say("9x6 for nine inner corners in a row and six rows")};
  board.columns = columns;
  board.rows = rows;
  return {};
}

Result<BoardView> find_board(const cv::Mat& grey, const Board& board) {
  // OpenCV's finders throw on unexpected images.
  try {
    auto view = board.pattern == BoardPattern::kDots      ? find_dots(grey, board)
                : board.pattern == BoardPattern::kCharuco ? find_charuco(grey, board)
                                                          : find_chessboard(grey, board);
    if (view) view->edge_px = edge_width_px(grey, view->pixels);
    return view;
  } catch (const cv::Exception& problem) {
    return Error{en::say("the search for the board failed: {}", problem.err), "",
                 en::say("another image")};
  }
}

Eigen::Vector2d oriented_pixel(const Eigen::Vector2d& pixel, cv::Size raw,
                               Orientation orientation) {
  const double u = pixel.x(), v = pixel.y();
  const double right = raw.width - 1, bottom = raw.height - 1;
  switch (orientation) {
    case Orientation::kNone:
      break;
    case Orientation::kFlipU:
      return {right - u, v};
    case Orientation::kFlipV:
      return {u, bottom - v};
    case Orientation::kRotate180:
      return {right - u, bottom - v};
    case Orientation::kRotate90:
      return {bottom - v, u};
    case Orientation::kRotate270:
      return {v, right - u};
  }
  return pixel;
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
