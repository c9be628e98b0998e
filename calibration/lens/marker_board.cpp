#include "calibration/lens/marker_board.h"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Dense>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kFewestCorners = 6;
constexpr int kFewestPairs = 3;        // of neighbouring markers, to accept a numbering
constexpr int kCertainPairs = 10;      // to accept it without further images
constexpr int kMaxPerRow = 100;        // squares or tags, as Board allows
constexpr double kNeighbourOff = 0.4;  // of a cell: a marker is not the expected neighbour

using SeenMarker = MarkerPrintRecogniser::SeenMarker;

/// The dictionary of a family with at least this many markers, if there is one.
int dictionary_number(MarkerDictionary dictionary, int markers) {
  const bool is_small = markers <= 250;
  switch (dictionary) {
    case MarkerDictionary::kAny:
    case MarkerDictionary::k4x4:
      return is_small ? cv::aruco::DICT_4X4_250 : cv::aruco::DICT_4X4_1000;
    case MarkerDictionary::k5x5:
      return is_small ? cv::aruco::DICT_5X5_250 : cv::aruco::DICT_5X5_1000;
    case MarkerDictionary::k6x6:
      return is_small ? cv::aruco::DICT_6X6_250 : cv::aruco::DICT_6X6_1000;
    case MarkerDictionary::k7x7:
      return is_small ? cv::aruco::DICT_7X7_250 : cv::aruco::DICT_7X7_1000;
    case MarkerDictionary::kOriginal:
      return cv::aruco::DICT_ARUCO_ORIGINAL;
    case MarkerDictionary::kApril16h5:
      return cv::aruco::DICT_APRILTAG_16h5;
    case MarkerDictionary::kApril25h9:
      return cv::aruco::DICT_APRILTAG_25h9;
    case MarkerDictionary::kApril36h10:
      return cv::aruco::DICT_APRILTAG_36h10;
    case MarkerDictionary::kApril36h11:
      break;
  }
  return cv::aruco::DICT_APRILTAG_36h11;
}

struct DetectedMarkers {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  std::size_t squares = 0;  ///< with and without a valid code
};

/// The image as upright markers would show it.
cv::Mat upright(const cv::Mat& grey, const MarkerPrint& print) {
  cv::Mat turned = grey, image = grey;
  if (print.is_mirrored) {
    turned = cv::Mat();
    cv::flip(grey, turned, 1);
    image = turned;
  }
  if (print.is_inverted) {
    image = cv::Mat();
    cv::bitwise_not(turned, image);
  }
  return image;
}

DetectedMarkers detect(const cv::Mat& image, const MarkerPrint& print, int markers) {
  DetectedMarkers found;
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = print.border_bits;
  std::vector<std::vector<cv::Point2f>> rejected;
  cv::aruco::detectMarkers(
      image, cv::aruco::getPredefinedDictionary(dictionary_number(print.dictionary, markers)),
      found.corners, found.ids, parameters, rejected);
  found.squares = found.corners.size() + rejected.size();
  // A number that appears twice is a misread marker; which one is open.
  std::map<int, int> count;
  for (const int id : found.ids) ++count[id];
  for (std::size_t i = found.ids.size(); i-- > 0;) {
    if (count[found.ids[i]] == 1) continue;
    found.ids.erase(found.ids.begin() + static_cast<std::ptrdiff_t>(i));
    found.corners.erase(found.corners.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return found;
}

Eigen::Vector2d vector_of(cv::Point2f point) { return {point.x, point.y}; }

std::vector<SeenMarker> seen_markers(const DetectedMarkers& found) {
  std::vector<SeenMarker> seen;
  for (std::size_t i = 0; i < found.ids.size(); ++i) {
    std::array<Eigen::Vector2d, 4> corner;  // clockwise from the marker's own top left
    for (std::size_t k = 0; k < 4; ++k) corner[k] = vector_of(found.corners[i][k]);
    SeenMarker& marker = seen.emplace_back();
    marker.id = found.ids[i];
    marker.centre = (corner[0] + corner[1] + corner[2] + corner[3]) / 4;
    marker.edges.col(0) = (corner[1] - corner[0] + corner[2] - corner[3]) / 2;
    marker.edges.col(1) = (corner[3] - corner[0] + corner[2] - corner[1]) / 2;
  }
  return seen;
}

/// A numbering of the cells of a board: squares of a ChArUco board, tags of an AprilGrid.
struct Numbering {
  BoardPattern pattern = BoardPattern::kCharuco;
  int per_row = 0;  ///< cells
  int first_id = 0;
  bool first_white = false, from_bottom = false;
  int quarter_turns = 0;

  /// Column and row of a marker; negative rows lie above the first. nullopt before the first id.
  [[nodiscard]] std::optional<Eigen::Vector2i> cell_of(int id) const {
    const int n = id - first_id;
    if (n < 0) return std::nullopt;
    if (pattern == BoardPattern::kAprilGrid) {
      const int row = n / per_row;
      return Eigen::Vector2i(n % per_row, from_bottom ? -row : row);
    }
    // Two rows together have a marker for each column.
    const int pair = n / per_row, in_pair = n % per_row;
    const int in_even = first_white ? (per_row + 1) / 2 : per_row / 2;
    if (in_pair < in_even) return Eigen::Vector2i(2 * in_pair + (first_white ? 0 : 1), 2 * pair);
    return Eigen::Vector2i(2 * (in_pair - in_even) + (first_white ? 1 : 0), 2 * pair + 1);
  }
};

Numbering numbering_of(const Board& board, const MarkerPrint& print) {
  const bool is_grid = board.pattern == BoardPattern::kAprilGrid;
  return {board.pattern,     is_grid ? board.columns : board.columns + 1,
          print.first_id,    print.first_white,
          print.from_bottom, print.quarter_turns};
}

/// Side of a marker as a fraction of a cell.
double marker_side(const Board& board) {
  return board.pattern == BoardPattern::kAprilGrid ? 1 / (1 + board.tag_spacing)
                                                   : board.marker_part;
}

/// Turns a vector in a marker's own frame into the board's frame.
Eigen::Vector2i turned(Eigen::Vector2i cell, int quarter_turns) {
  for (int i = 0; i < quarter_turns; ++i) cell = Eigen::Vector2i(cell.y(), -cell.x());
  return cell;
}

/// Pairs of markers in adjacent rows of the numbering: those that are neighbours in the image, and
/// those that are not.
struct Agreement {
  int neighbours = 0, others = 0;
  [[nodiscard]] int score() const { return neighbours - others; }
  [[nodiscard]] bool is_accepted() const {
    return neighbours >= kFewestPairs && neighbours >= 4 * others;
  }
};

/// `of_marker`: receives each marker's own agreement.
Agreement agreement(const std::vector<SeenMarker>& seen, const Numbering& numbering, double side,
                    std::vector<Agreement>* of_marker = nullptr) {
  Agreement sum;
  if (of_marker != nullptr) of_marker->assign(seen.size(), {});
  std::map<std::pair<int, int>, std::size_t> cells;
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (const auto cell = numbering.cell_of(seen[i].id)) cells[{cell->x(), cell->y()}] = i;
  for (const auto& [cell, i] : cells) {
    const SeenMarker& marker = seen[i];
    const double near_px = kNeighbourOff * marker.edges.colwise().norm().minCoeff() / side;
    for (const int down : {-1, 1})
      for (const int right : {-1, 0, 1}) {
        const auto other = cells.find({cell.first + right, cell.second + down});
        if (other == cells.end()) continue;
        const Eigen::Vector2d step =
            turned({right, down}, numbering.quarter_turns).cast<double>() / side;
        const Eigen::Vector2d expected = marker.centre + marker.edges * step;
        const bool is_neighbour = (seen[other->second].centre - expected).norm() < near_px;
        ++(is_neighbour ? sum.neighbours : sum.others);
        if (of_marker == nullptr) continue;
        for (const std::size_t k : {i, other->second})
          ++(is_neighbour ? (*of_marker)[k].neighbours : (*of_marker)[k].others);
      }
  }
  return sum;
}

struct BestNumbering {
  Numbering numbering;
  Agreement agreement;
};

/// The numbering that most pairs of all images agree with; of equal ones the board's own.
BestNumbering best_numbering(const std::vector<std::vector<SeenMarker>>& images,
                             const Board& board) {
  const bool is_grid = board.pattern == BoardPattern::kAprilGrid;
  const int given = numbering_of(board, {}).per_row;
  int first_seen = std::numeric_limits<int>::max();
  for (const auto& seen : images)
    for (const SeenMarker& marker : seen) first_seen = std::min(first_seen, marker.id);
  BestNumbering best;
  const auto attempt = [&](const Numbering& numbering) {
    Agreement sum;
    for (const auto& seen : images) {
      const Agreement one = agreement(seen, numbering, marker_side(board));
      sum.neighbours += one.neighbours, sum.others += one.others;
    }
    if (sum.score() > best.agreement.score()) best = {numbering, sum};
  };
  std::vector<int> per_row{given};
  for (int n = 2; n <= kMaxPerRow; ++n)
    if (n != given) per_row.push_back(n);
  const auto attempt_all = [&](int n, int first_id) {
    for (const bool second : {false, true})
      for (int turns = 0; turns < (is_grid ? 4 : 1); ++turns)
        attempt({board.pattern, n, first_id, !is_grid && second, is_grid && second, turns});
  };
  for (const int n : per_row) attempt_all(n, 0);
  if (best.agreement.is_accepted()) return best;
  // Numbers that begin elsewhere: two rows more or less only move the board's origin.
  for (int before = 0; before < given && before < first_seen; ++before)
    attempt_all(given, first_seen - before);
  return best;
}

/// Dictionaries, borders and sides in the order in which they are tried.
std::vector<MarkerPrint> readings_to_try(const Board& board) {
  using D = MarkerDictionary;
  std::vector<D> all{D::k4x4,       D::k5x5,       D::k6x6,        D::k7x7,       D::kOriginal,
                     D::kApril16h5, D::kApril25h9, D::kApril36h10, D::kApril36h11};
  if (board.pattern == BoardPattern::kAprilGrid) std::reverse(all.begin(), all.end());
  if (const auto given = std::find(all.begin(), all.end(), board.dictionary); given != all.end())
    std::rotate(all.begin(), given, given + 1);
  std::vector<MarkerPrint> readings;
  for (const bool is_mirrored : {false, true})
    for (const bool is_inverted : {false, true})
      for (const D dictionary : all)
        for (const int border_bits : {2, 1}) {
          if (border_bits == 2 && board.pattern != BoardPattern::kAprilGrid) continue;
          MarkerPrint& reading = readings.emplace_back();
          reading.dictionary = dictionary;
          reading.border_bits = border_bits;
          reading.is_mirrored = is_mirrored;
          reading.is_inverted = is_inverted;
        }
  return readings;
}

/// Markers that contradict their neighbours are removed: they were misread.
void remove_misread(DetectedMarkers& found, const Board& board, const MarkerPrint& print) {
  std::vector<Agreement> of_marker;
  agreement(seen_markers(found), numbering_of(board, print), marker_side(board), &of_marker);
  for (std::size_t i = found.ids.size(); i-- > 0;) {
    if (of_marker[i].others <= of_marker[i].neighbours) continue;
    found.ids.erase(found.ids.begin() + static_cast<std::ptrdiff_t>(i));
    found.corners.erase(found.corners.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// A sub-board of OpenCV's layout: a first white square stands in the second row of a board with
/// one row more, and its markers have the numbers that follow those of the first row.
Result<BoardView> charuco_view(const cv::Mat& image, const Board& board, const MarkerPrint& print,
                               DetectedMarkers& found) {
  const int squares = board.columns + 1, above = print.first_white ? 1 : 0;
  const auto square = static_cast<float>(board.square_mm);
  const auto charuco = cv::aruco::CharucoBoard::create(
      squares, board.rows + 1 + above, square, square * static_cast<float>(board.marker_part),
      cv::aruco::getPredefinedDictionary(dictionary_number(print.dictionary, 0)));
  for (int& id : found.ids) id += above * (squares / 2) - print.first_id;
  std::vector<cv::Point2f> corners;
  std::vector<int> ids;
  cv::aruco::interpolateCornersCharuco(found.corners, found.ids, image, charuco, corners, ids);
  BoardView view;
  std::vector<cv::Point2f> on_board;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int id = ids[i] - above * board.columns;
    if (id < 0) continue;  // on the board's upper edge
    view.board_mm.push_back(board.point_mm(id));
    on_board.push_back(corners[i]);
  }
  // Markers fill the squares around a corner, so the window ends before them.
  refine_corners(image, on_board, 0.5 * (1 - board.marker_part));
  for (const cv::Point2f& corner : on_board) view.pixels.push_back(vector_of(corner));
  return view;
}

BoardView april_view(const cv::Mat& image, const Board& board, const MarkerPrint& print,
                     const DetectedMarkers& found) {
  const Numbering numbering = numbering_of(board, print);
  BoardView view;
  std::vector<cv::Point2f> corners;
  for (std::size_t i = 0; i < found.ids.size(); ++i) {
    const auto cell = numbering.cell_of(found.ids[i]);
    if (!cell) continue;
    const int row = cell->y() + (print.from_bottom ? board.rows - 1 : 0);
    if (row < 0 || row >= board.rows) continue;
    for (int k = 0; k < 4; ++k) {
      // Corner k of the turned code is a later corner of the board's tag.
      view.board_mm.push_back(
          board.point_mm(4 * (row * board.columns + cell->x()) + (k + print.quarter_turns) % 4));
      corners.push_back(found.corners[i][static_cast<std::size_t>(k)]);
    }
  }
  refine_corners(image, corners, 0.5);
  for (const cv::Point2f& corner : corners) view.pixels.push_back(vector_of(corner));
  return view;
}

Message pattern_name(const Board& board) {
  return board.pattern == BoardPattern::kAprilGrid ? en::say("AprilGrid")
                                                   : en::say("ChArUco board");
}

Error no_markers(const cv::Mat& grey, const Board& board) {
  Error error = no_board_error(grey, board, pattern_name(board));
  error.what = en::clauses({error.what, en::say("not one of its markers")});
  return error;
}

}  // namespace

void MarkerPrintRecogniser::add(const cv::Mat& grey) {
  constexpr int kAllMarkers = 1000;
  if (reading_) {
    if (images_.size() >= kMaxSearches) images_.erase(images_.begin());
    images_.push_back(seen_markers(detect(upright(grey, *reading_), *reading_, kAllMarkers)));
    return;
  }
  if (searches_ >= kMaxSearches) return;
  int best = 0;
  std::vector<SeenMarker> best_seen;
  for (const MarkerPrint& reading : readings_to_try(board_)) {
    // An upright board with another dictionary is more likely than a mirrored one with this.
    if (reading_ && (reading.is_mirrored != reading_->is_mirrored ||
                     reading.is_inverted != reading_->is_inverted))
      break;
    const DetectedMarkers found = detect(upright(grey, reading), reading, kAllMarkers);
    constexpr std::size_t kFewestSquares = 4;
    if (!reading_ && !reading.is_mirrored && !reading.is_inverted && found.squares < kFewestSquares)
      return;
    auto seen = seen_markers(found);
    const Agreement agreed = best_numbering({seen}, board_).agreement;
    if (!agreed.is_accepted() || agreed.score() <= best) continue;
    best = agreed.score();
    best_seen = std::move(seen);
    reading_ = reading;
    if (best >= kCertainPairs) break;
  }
  ++searches_;
  if (reading_) images_.push_back(std::move(best_seen));
}

bool MarkerPrintRecogniser::is_certain() const {
  if (!reading_) return false;
  const Agreement agreed = best_numbering(images_, board_).agreement;
  return agreed.is_accepted() && agreed.neighbours >= kCertainPairs;
}

Result<MarkerPrint> MarkerPrintRecogniser::print() const {
  const BestNumbering best = best_numbering(images_, board_);
  if (!reading_ || !best.agreement.is_accepted())
    return Error{en::say("no markers in the order of this board are visible"), "",
                 en::say("--board and --pattern that match the board, and all of it in the image")};
  MarkerPrint print = *reading_;
  print.first_id = best.numbering.first_id;
  print.first_white = best.numbering.first_white;
  print.from_bottom = best.numbering.from_bottom;
  print.quarter_turns = best.numbering.quarter_turns;
  if (board_.dictionary != MarkerDictionary::kAny && board_.dictionary != print.dictionary)
    return Error{en::say("the markers of this board are of the dictionary {}, not {}",
                         to_string(print.dictionary), to_string(board_.dictionary)),
                 std::string("--dictionary"),
                 en::say("--dictionary {}", to_string(print.dictionary))};
  int last_row = 0;
  for (const auto& seen : images_) {
    std::vector<Agreement> of_marker;
    agreement(seen, best.numbering, marker_side(board_), &of_marker);
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (of_marker[i].neighbours > of_marker[i].others)
        last_row = std::max(last_row, std::abs(best.numbering.cell_of(seen[i].id)->y()));
  }
  Board shown = board_;
  const int border = board_.pattern == BoardPattern::kAprilGrid ? 0 : 1;
  shown.columns = best.numbering.per_row - border;
  shown.rows = last_row + 1 - border;
  if (shown.columns == board_.columns && shown.rows <= board_.rows) return print;
  return other_size_error(shown, board_);
}

Result<BoardView> find_marker_board(const cv::Mat& grey, const Board& board,
                                    const MarkerPrint& print) {
  const cv::Mat image = upright(grey, print);
  const bool is_grid = board.pattern == BoardPattern::kAprilGrid;
  const int count =
      is_grid ? board.columns * board.rows : ((board.columns + 1) * (board.rows + 1) + 1) / 2;
  DetectedMarkers found = detect(image, print, print.first_id + count);
  if (found.ids.empty()) {
    MarkerPrint mirrored = print;
    mirrored.is_mirrored = !print.is_mirrored;
    if (detect(upright(grey, mirrored), mirrored, count).ids.size() >= kFewestPairs)
      return Error{en::say("this image is mirrored, unlike others"), "",
                   en::say("images from one camera in one mode")};
    return no_markers(grey, board);
  }
  remove_misread(found, board, print);
  auto view =
      is_grid ? april_view(image, board, print, found) : charuco_view(image, board, print, found);
  if (!view) return view;
  if (static_cast<int>(view->pixels.size()) < kFewestCorners)
    return Error{en::say("only {} of the board's corners are visible, {} are needed",
                         view->pixels.size(), kFewestCorners),
                 "", en::say("more of the board in the image, sharp and evenly lit")};
  if (!spans_a_plane(view->board_mm))
    return Error{en::say("only corners in one line of the board are visible"), "",
                 en::say("more of the board in the image")};
  if (print.is_mirrored)
    for (Eigen::Vector2d& pixel : view->pixels) pixel.x() = grey.cols - 1 - pixel.x();
  return view;
}

std::vector<Message> print_remarks(const Board& board) {
  std::vector<Message> remarks;
  if (!board.print) return remarks;
  const MarkerPrint& print = *board.print;
  const bool is_grid = board.pattern == BoardPattern::kAprilGrid;
  const MarkerDictionary typical = is_grid ? MarkerDictionary::kApril36h11 : MarkerDictionary::k4x4;
  if (board.dictionary == MarkerDictionary::kAny && print.dictionary != typical)
    remarks.push_back(
        en::say("the markers of this board are of the dictionary {}", to_string(print.dictionary)));
  const bool has_two_layouts = (board.rows + 1) % 2 == 0;
  if (!is_grid && print.first_white)
    remarks.push_back(
        has_two_layouts
            ? en::say("this board has the layout of OpenCV before 4.6 and of calib.io: its first "
                      "square is white")
            : en::say("the first square of this board is white, with a marker"));
  else if (!is_grid && has_two_layouts)
    remarks.push_back(
        en::say("this board has the layout of OpenCV from 4.6 on: its first square is black"));
  if (print.first_id > 0)
    remarks.push_back(en::say("the markers of this board are counted from {}", print.first_id));
  if (print.is_mirrored)
    remarks.push_back(
        en::say("the board is mirrored in these images; the lens is valid for images that are "
                "mirrored in the same direction"));
  if (print.is_inverted) remarks.push_back(en::say("black and white of this board are exchanged"));
  return remarks;
}

}  // namespace alltact
