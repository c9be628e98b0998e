// Flat boards of known size, and their views in images.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"

#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

enum class BoardPattern { kChessboard = 1, kCharuco, kDots };
enum class MarkerDictionary { k4x4 = 1, k5x5, k6x6, kOriginal };

/// Columns and rows count inner corners (chessboard, ChArUco) or dots.
struct Board {
  BoardPattern pattern = BoardPattern::kChessboard;
  int columns = 0, rows = 0;  ///< 3 to 100 each
  double square_mm = 0;       ///< side of a square, or distance of two dots; (0, 1000]
  MarkerDictionary dictionary = MarkerDictionary::k4x4;  ///< ChArUco only
  /// ChArUco only: a marker's side as a fraction of the square's, (0, 1)
  double marker_part = 0.75;

  /// Position of the i-th corner or dot on the board, counted row by row from 0; z = 0.
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
/// completely visible; of a ChArUco board six corners are enough. Dots are dark on bright or bright
/// on dark. Their centres are the centroids of their images, which in perspective are not the
/// images of their centres (see without_dot_bias). Error: why there is none; `where` is left empty.
[[nodiscard]] Result<BoardView> find_board(const cv::Mat& grey, const Board& board);

/// A size near the requested one with which a chessboard is found, in words ("8 x 5"); empty when
/// there is none. Slow.
[[nodiscard]] std::string other_size_found(const cv::Mat& grey, const Board& board);

/// Maps a pixel of the raw image to the oriented image; `raw` is the raw image's size.
[[nodiscard]] Eigen::Vector2d oriented_pixel(const Eigen::Vector2d& pixel, cv::Size raw,
                                             Orientation orientation);

}  // namespace alltact
