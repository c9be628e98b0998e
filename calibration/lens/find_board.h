// The finders behind find_board(), one for each pattern. They may throw cv::Exception.
#pragma once

#include "calibration/lens/board.h"

namespace alltact {

[[nodiscard]] Result<BoardView> find_chessboard(const cv::Mat& grey, const Board& board);
[[nodiscard]] Result<BoardView> find_charuco(const cv::Mat& grey, const Board& board);
[[nodiscard]] Result<BoardView> find_dots(const cv::Mat& grey, const Board& board);

/// Median width of the edges around these pixels: contrast over the steepest slope. A sharp image
/// has about 1 to 2.
[[nodiscard]] double edge_width_px(const cv::Mat& grey, const std::vector<Eigen::Vector2d>& pixels);

/// Half the distance of the two nearest of these pixels.
[[nodiscard]] double half_spacing_px(const std::vector<Eigen::Vector2d>& pixels);

/// "no ... can be seen", with the reason as far as the image shows it.
[[nodiscard]] Error no_board(const cv::Mat& grey, const Board& board, const Message& pattern);

}  // namespace alltact
