// Flat boards of known size, and their views in images.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

enum class BoardPattern { kChessboard = 1, kCharuco, kDots, kAsymmetricDots, kAprilGrid };

/// Families of OpenCV's predefined dictionaries. Those of one family with 50 to 1000 markers begin
/// with the same markers.
enum class MarkerDictionary {
  kAny = 1,  ///< the one that the images show
  k4x4,
  k5x5,
  k6x6,
  k7x7,
  kOriginal,
  kApril16h5,
  kApril25h9,
  kApril36h10,
  kApril36h11
};
/// "4x4", "apriltag_36h11", ...: for flags and files.
[[nodiscard]] const std::string& to_string(MarkerDictionary dictionary);

/// How the markers of a board are printed, and from which side the images show them. Images decide
/// it: see MarkerPrintRecogniser.
struct MarkerPrint {
  MarkerDictionary dictionary = MarkerDictionary::k4x4;
  int first_id = 0;          ///< of the first marker; rows are numbered one after the other
  bool first_white = false;  ///< ChArUco: the first square is white and has a marker
  bool from_bottom = false;  ///< AprilGrid: the bottom row is the first
  int quarter_turns = 0;     ///< AprilGrid: of each tag's own image, clockwise
  int border_bits = 1;       ///< width of a marker's black border, in cells of its code
  bool is_mirrored = false;  ///< in the images
  bool is_inverted = false;  ///< black and white are exchanged
};

/// Columns and rows count inner corners (chessboard, ChArUco), dots, or tags (AprilGrid).
struct Board {
  BoardPattern pattern = BoardPattern::kChessboard;
  int columns = 0, rows = 0;  ///< 3 to 100 each
  /// Side of a square, of a tag, or distance of two dots; asymmetric dots: of two rows; (0, 1000]
  double square_mm = 0;
  MarkerDictionary dictionary = MarkerDictionary::kAny;  ///< ChArUco and AprilGrid
  /// ChArUco only: a marker's side as a fraction of the square's, (0, 1)
  double marker_part = 0.75;
  double tag_spacing = 0.3;  ///< AprilGrid only: gap of two tags as a fraction of a tag's side
  std::optional<MarkerPrint> print = std::nullopt;  ///< empty: not recognised

  [[nodiscard]] bool has_markers() const {
    return pattern == BoardPattern::kCharuco || pattern == BoardPattern::kAprilGrid;
  }
  /// Number of corners or dots.
  [[nodiscard]] int point_count() const;
  /// Position of the i-th corner or dot on the board, counted row by row from 0; z = 0. Asymmetric
  /// dots: every second row is shifted to the right by half the distance of its dots. AprilGrid:
  /// four corners of each tag, clockwise from the top left.
  [[nodiscard]] Eigen::Vector3d point_mm(int i) const;
  /// "6 x 6 inner corners".
  [[nodiscard]] Message words() const;
};

/// Parses "9x6" as columns and rows. Error: something else.
[[nodiscard]] Status set_board_size(Board& board, std::string_view text);

/// The corners, or dots, of one board in one image.
struct BoardView {
  std::string name;
  std::vector<Eigen::Vector3d> board_mm;  ///< on the board; z = 0
  std::vector<Eigen::Vector2d> pixels;    ///< of each point in the image
  double edge_px = 0;                     ///< width of the pattern's edges in the image, median
  double dot_part = 0;  ///< dots only: a dot's diameter as a fraction of their distance
};

/// Finds the board in a grey image, to a fraction of a pixel. Chessboards and dot grids must be
/// completely visible; of a board with markers six corners are enough. Dots are dark on bright or
/// bright on dark. Markers whose print is not recognised are recognised in this image. Their
/// centres are the centroids of their images, which in perspective are not the images of their
/// centres (see without_dot_bias). Error: why there is none; `where` is left empty.
[[nodiscard]] Result<BoardView> find_board(const cv::Mat& grey, const Board& board);

/// The board that these images show instead of the requested one, as an error: another size or
/// another pattern. nullopt when there is none. Slow: for images in which no board was found.
[[nodiscard]] std::optional<Error> other_board(const std::vector<cv::Mat>& images,
                                               const Board& board);

/// The board has the size of `shown` instead of that of `board`.
[[nodiscard]] Error other_size_error(const Board& shown, const Board& board);

/// Why no board can be found: the image's contrast, or `pattern` with the board's size is missing.
[[nodiscard]] Error no_board_error(const cv::Mat& grey, const Board& board, const Message& pattern);

/// Moves corners to a fraction of a pixel. The window around each reaches up to `reach` of the
/// distance to the next corner.
void refine_corners(const cv::Mat& grey, std::vector<cv::Point2f>& corners, double reach);

/// False when points lie in a line, or nearly.
[[nodiscard]] bool spans_a_plane(const std::vector<Eigen::Vector3d>& points);

/// Maps a pixel of the raw image to the oriented image; `raw` is the raw image's size.
[[nodiscard]] Eigen::Vector2d oriented_pixel(const Eigen::Vector2d& pixel, cv::Size raw,
                                             Orientation orientation);

}  // namespace alltact
