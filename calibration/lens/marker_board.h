// Boards with markers: ChArUco boards and AprilGrids, as different programs number them.
#pragma once

#include "calibration/lens/board.h"
#include "core/base/result.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Recognises how a board's markers are printed. Every dictionary is tried, upright, inverted and
/// mirrored. Then every numbering is compared with the geometry of the image: each marker predicts
/// where the numbering expects its neighbours.
///   ChArUco: OpenCV from 4.6 begins with a black square. OpenCV before 4.6 and calib.io begin with
///   a white one on boards with an even number of rows. Other programs begin with either.
///   AprilGrid: Kalibr numbers tags from the bottom left, with a border of two cells and tags
///   turned by 180 degrees; OpenCV's grids begin at the top left.
/// Not thread-safe.
class MarkerPrintRecogniser {
 public:
  explicit MarkerPrintRecogniser(const Board& board) : board_(board) {}

  /// Searches markers in an image. Tries all dictionaries until one is recognised, at most in
  /// kMaxSearches images.
  void add(const cv::Mat& grey);

  /// The images so far leave no doubt.
  [[nodiscard]] bool is_certain() const;

  /// The print that explains the markers best. Errors: no markers that are ordered as a board's, a
  /// dictionary other than the given one, another number of columns or rows.
  [[nodiscard]] Result<MarkerPrint> print() const;

  static constexpr int kMaxSearches = 12;

  struct SeenMarker {
    int id = 0;
    Eigen::Vector2d centre;
    Eigen::Matrix2d edges;  ///< columns: the marker's horizontal and vertical side, px
  };

 private:
  Board board_;
  int searches_ = 0;
  std::optional<MarkerPrint> reading_;  // dictionary, border, mirrored and inverted only
  std::vector<std::vector<SeenMarker>> images_;
};

/// Finds a ChArUco board or an AprilGrid whose print is known. Error: as find_board.
[[nodiscard]] Result<BoardView> find_marker_board(const cv::Mat& grey, const Board& board,
                                                  const MarkerPrint& print);

/// What is unusual about a recognised print, each in one sentence for the user.
[[nodiscard]] std::vector<Message> print_remarks(const Board& board);

}  // namespace alltact
