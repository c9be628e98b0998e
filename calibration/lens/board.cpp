#include "calibration/lens/board.h"

#include "calibration/lens/marker_board.h"
#include "core/base/message.h"
#include "core/image/grey_range.h"
#include "core/numerics/median.h"

#include <array>
#include <charconv>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

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

bool find_sharp_corners(const cv::Mat& grey, cv::Size size, std::vector<cv::Point2f>& corners) {
  return cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE) ||
         cv::findChessboardCornersSB(grey, size, corners,
                                     cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_NORMALIZE_IMAGE);
}

/// Detects some strongly bent boards that the other misses. It also accepts a part of a larger
/// board.
bool find_bent_corners(const cv::Mat& grey, cv::Size size, std::vector<cv::Point2f>& corners) {
  constexpr int kClassic = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE |
                           cv::CALIB_CB_FILTER_QUADS | cv::CALIB_CB_FAST_CHECK;
  return cv::findChessboardCorners(grey, size, corners, kClassic);
}

/// The size of a chessboard with at least `least` inner corners in its rows and columns.
std::optional<cv::Size> chessboard_size(const cv::Mat& grey, cv::Size least) {
  std::vector<cv::Point2f> corners;
  cv::Mat meta;
  if (!cv::findChessboardCornersSB(grey, least, corners,
                                   cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_LARGER, meta))
    return std::nullopt;
  // A few times the finder counts a white border: only what the strict search confirms counts.
  const cv::Size size = meta.size();
  if (size.width < 3 || size.height < 3 ||
      !cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE))
    return std::nullopt;
  return size;
}

bool are_equal_sizes(cv::Size a, cv::Size b) { return a == b || a == cv::Size(b.height, b.width); }

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

/// `board` with this size, its counts in the order of the given ones: a chessboard has no first
/// direction.
Board chessboard_of(const Board& board, cv::Size size) {
  if ((size.width < size.height) != (board.columns < board.rows))
    std::swap(size.width, size.height);
  Board other = board;
  other.pattern = BoardPattern::kChessboard;
  other.columns = size.width, other.rows = size.height;
  return other;
}

Result<BoardView> find_chessboard(const cv::Mat& grey, const Board& board) {
  const cv::Size size(board.columns, board.rows);
  std::vector<cv::Point2f> corners;
  if (!find_sharp_corners(grey, size, corners)) {
    if (!find_bent_corners(grey, size, corners))
      return no_board_error(grey, board, en::say("chessboard"));
    if (const auto shown = chessboard_size(grey, size); shown && !are_equal_sizes(*shown, size))
      return other_size_error(chessboard_of(board, *shown), board);
  }
  // The finders' own corners are precise to a tenth of a pixel on sharp images only.
  refine_corners(grey, corners, kHalfSpacing);
  return full_view(board, corners);
}

// Dot grids: OpenCV orders the blobs, then each dot is measured by its grey values.

constexpr float kTiltedDot = 0.4F;  // circularity: a tilted dot is an ellipse
constexpr float kNoSquare = 0.84F;  // a square has 0.785

cv::Ptr<cv::SimpleBlobDetector> dot_detector(cv::Size image, float min_circularity) {
  cv::SimpleBlobDetector::Params how;
  how.minArea = 12;
  // The largest dot of the smallest board, when it fills the image.
  constexpr int kFewestDots = 9;
  how.maxArea = static_cast<float>(image.area()) / kFewestDots;
  how.minDistBetweenBlobs = 4;
  how.filterByConvexity = false;
  how.filterByInertia = false;
  how.filterByCircularity = true;
  how.minCircularity = min_circularity;
  return cv::SimpleBlobDetector::create(how);
}

bool find_grid(const cv::Mat& dark_dots, const Board& board, float min_circularity,
               std::vector<cv::Point2f>& centres) {
  const int grid = board.pattern == BoardPattern::kAsymmetricDots ? cv::CALIB_CB_ASYMMETRIC_GRID
                                                                  : cv::CALIB_CB_SYMMETRIC_GRID;
  return cv::findCirclesGrid(dark_dots, {board.columns, board.rows}, centres, grid,
                             dot_detector(dark_dots.size(), min_circularity));
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

/// Vectors from a grid point to the next in its row and in its column, px; of asymmetric dots, two
/// perpendicular vectors on the board that are as long as the distance to the nearest dot.
Eigen::Matrix2d spacing_at(const std::vector<cv::Point2f>& centres, const Board& board, int i) {
  const auto between = [&](int at, int count, int step) -> Eigen::Vector2d {
    const int after = at + 1 < count ? step : 0, before = at > 0 ? step : 0;
    const cv::Point2f step_px = centres[static_cast<std::size_t>(std::ptrdiff_t{i} + after)] -
                                centres[static_cast<std::size_t>(i - before)];
    return Eigen::Vector2d(step_px.x, step_px.y) / (after > 0 && before > 0 ? 2.0 : 1.0);
  };
  const int column = i % board.columns, row = i / board.columns;
  Eigen::Matrix2d spacing;
  spacing.col(0) = between(column, board.columns, 1);
  if (board.pattern != BoardPattern::kAsymmetricDots) {
    spacing.col(1) = between(row, board.rows, board.columns);
    return spacing;
  }
  // Dots of a row are two units apart, and every second row is aligned; the nearest dot is
  // sqrt(2) units away.
  const int two_rows = 2 * board.columns;
  const bool has_after = row + 2 < board.rows, has_before = row >= 2;
  const cv::Point2f step_px = centres[static_cast<std::size_t>(i + (has_after ? two_rows : 0))] -
                              centres[static_cast<std::size_t>(i - (has_before ? two_rows : 0))];
  spacing.col(1) = Eigen::Vector2d(step_px.x, step_px.y) / (has_after && has_before ? 2.0 : 1.0);
  return spacing * M_SQRT1_2;
}

Result<BoardView> find_dots(const cv::Mat& grey, const Board& board) {
  std::vector<cv::Point2f> centres;
  cv::Mat dark_dots = grey;
  if (!find_grid(dark_dots, board, kTiltedDot, centres)) {
    cv::bitwise_not(grey, dark_dots);
    if (!find_grid(dark_dots, board, kTiltedDot, centres))
      return no_board_error(grey, board, en::say("dot grid"));
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

/// The board in this image, whose print is recognised in it.
Result<BoardView> find_unrecognised(const cv::Mat& grey, const Board& board) {
  MarkerPrintRecogniser recogniser(board);
  recogniser.add(grey);
  const auto print = recogniser.print();
  if (!print) return print.error();
  return find_marker_board(grey, board, *print);
}

}  // namespace

const std::string& to_string(MarkerDictionary dictionary) {
  static const std::array<std::string, 10> kWords{
      "any",           "4x4",           "5x5",
      "6x6",           "7x7",           "original",
      "apriltag_16h5", "apriltag_25h9", "apriltag_36h10",
      "apriltag_36h11"};
  return kWords.at(static_cast<std::size_t>(dictionary) - 1);
}

int Board::point_count() const {
  return columns * rows * (pattern == BoardPattern::kAprilGrid ? 4 : 1);
}

Eigen::Vector3d Board::point_mm(int i) const {
  if (pattern == BoardPattern::kAprilGrid) {
    const int tag = i / 4, corner = i % 4;
    const double cell_mm = square_mm * (1 + tag_spacing);
    return {cell_mm * (tag % columns) + (corner == 1 || corner == 2 ? square_mm : 0),
            cell_mm * (tag / columns) + (corner >= 2 ? square_mm : 0), 0};
  }
  const int row = i / columns, column = i % columns;
  if (pattern == BoardPattern::kAsymmetricDots)
    return {square_mm * (2 * column + row % 2), square_mm * row, 0};
  return {square_mm * column, square_mm * row, 0};
}

Message Board::words() const {
  Message counted;
  switch (pattern) {
    case BoardPattern::kChessboard:
    case BoardPattern::kCharuco:
      counted = en::say("inner corners");
      break;
    case BoardPattern::kDots:
      counted = en::say("dots");
      break;
    case BoardPattern::kAsymmetricDots:
      counted = en::say("asymmetric dots");
      break;
    case BoardPattern::kAprilGrid:
      counted = en::say("tags");
      break;
  }
  return en::say("{} x {} {}", columns, rows, counted);
}

Error other_size_error(const Board& shown, const Board& board) {
  Message counting = en::say("inner corners are counted, not squares");
  if (board.pattern == BoardPattern::kAprilGrid)
    counting = en::say("tags of a row and of a column are counted");
  else if (board.pattern == BoardPattern::kDots || board.pattern == BoardPattern::kAsymmetricDots)
    counting = en::say("dots of a row and of a column are counted");
  return {en::say("this board has {}, not {} x {}", shown.words(), board.columns, board.rows),
          std::string("--board"),
          en::say("--board {}x{}: {}", shown.columns, shown.rows, counting)};
}

Error no_board_error(const cv::Mat& grey, const Board& board, const Message& pattern) {
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

void refine_corners(const cv::Mat& grey, std::vector<cv::Point2f>& corners, double reach) {
  const std::vector<int> windows = windows_px(corners, reach);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::vector<cv::Point2f> one{corners[i]};
    const cv::Size window(windows[i], windows[i]);
    cv::cornerSubPix(grey, one, window, {-1, -1},
                     {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-4});
    corners[i] = one.front();
  }
}

bool spans_a_plane(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : points)
    spread += (point - mean).head<2>() * (point - mean).head<2>().transpose();
  return spread.determinant() > 1e-3 * spread.trace() * spread.trace() / 4;
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
    auto view = !board.has_markers() ? board.pattern == BoardPattern::kChessboard
                                           ? find_chessboard(grey, board)
                                           : find_dots(grey, board)
                : board.print ? find_marker_board(grey, board, *board.print)
                                     : find_unrecognised(grey, board);
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

namespace {

/// The requested size, the swapped one, and all that differ by one in a count.
std::vector<cv::Size> sizes_near(const Board& board) {
  std::vector<cv::Size> sizes;
  for (const cv::Size middle :
       {cv::Size(board.columns, board.rows), cv::Size(board.rows, board.columns)})
    for (const int wider : {0, -1, 1})
      for (const int higher : {0, -1, 1}) {
        const cv::Size size(middle.width + wider, middle.height + higher);
        if (size.width >= 3 && size.height >= 3 &&
            std::find(sizes.begin(), sizes.end(), size) == sizes.end())
          sizes.push_back(size);
      }
  return sizes;
}

std::optional<Board> other_chessboard(const cv::Mat& grey, const Board& board) {
  if (const auto size = chessboard_size(grey, {3, 3})) return chessboard_of(board, *size);
  for (const cv::Size size : sizes_near(board)) {
    std::vector<cv::Point2f> corners;
    if (size.width >= size.height &&
        cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_EXHAUSTIVE))
      return chessboard_of(board, size);
  }
  return std::nullopt;
}

std::optional<Board> other_dots(const cv::Mat& grey, const Board& board) {
  cv::Mat inverted;
  cv::bitwise_not(grey, inverted);
  Board other = board;
  for (const cv::Mat& dark_dots : {grey, inverted}) {
    std::vector<cv::KeyPoint> dots;
    dot_detector(grey.size(), kNoSquare)->detect(dark_dots, dots);
    for (const BoardPattern pattern : {BoardPattern::kDots, BoardPattern::kAsymmetricDots})
      for (const cv::Size size : sizes_near(board)) {
        if (size.area() > static_cast<int>(dots.size())) continue;
        other.pattern = pattern;
        other.columns = size.width, other.rows = size.height;
        std::vector<cv::Point2f> centres;
        if (find_grid(dark_dots, other, kNoSquare, centres)) return other;
      }
  }
  return std::nullopt;
}

bool shows_markers(const cv::Mat& grey, const Board& board, BoardPattern pattern) {
  Board other = board;
  other.pattern = pattern;
  other.dictionary = MarkerDictionary::kAny;
  MarkerPrintRecogniser recogniser(other);
  recogniser.add(grey);
  return recogniser.is_certain();
}

std::optional<Error> other_board_in(const cv::Mat& grey, const Board& board) {
  const auto of_pattern = [&](const Message& shown, const std::string& flags) -> Error {
    return {en::say("this board is {}", shown), std::string("--pattern"), Message::typed(flags)};
  };
  const auto size_flag = [](const Board& other) {
    return fmt::format("--board {}x{}", other.columns, other.rows);
  };
  // Dots first: the finder of chessboards sees small ones between dots.
  if (const auto dots = other_dots(grey, board)) {
    if (dots->pattern == board.pattern) return other_size_error(*dots, board);
    return dots->pattern == BoardPattern::kDots
               ? of_pattern(en::say("a symmetric grid with {}", dots->words()),
                            "--pattern dots " + size_flag(*dots))
               : of_pattern(en::say("a grid with {}", dots->words()),
                            "--pattern asymmetric_dots " + size_flag(*dots));
  }
  const auto chessboard = other_chessboard(grey, board);
  if (chessboard && board.pattern == BoardPattern::kChessboard) {
    if (are_equal_sizes({chessboard->columns, chessboard->rows}, {board.columns, board.rows}))
      return std::nullopt;
    return other_size_error(*chessboard, board);
  }
  if (board.pattern != BoardPattern::kCharuco && shows_markers(grey, board, BoardPattern::kCharuco))
    return of_pattern(en::say("a ChArUco board"), "--pattern charuco");
  if (board.pattern != BoardPattern::kAprilGrid &&
      shows_markers(grey, board, BoardPattern::kAprilGrid))
    return of_pattern(en::say("an AprilGrid"), "--pattern aprilgrid");
  if (chessboard)
    return of_pattern(en::say("a chessboard with {}", chessboard->words()),
                      "--pattern chessboard " + size_flag(*chessboard));
  return std::nullopt;
}

}  // namespace

std::optional<Error> other_board(const std::vector<cv::Mat>& images, const Board& board) {
  for (const cv::Mat& grey : images) {
    try {
      if (auto other = other_board_in(grey, board)) return other;
    } catch (const cv::Exception&) {
      continue;  // OpenCV's finders throw on unexpected images
    }
  }
  return std::nullopt;
}

}  // namespace alltact
