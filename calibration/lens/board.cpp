#include "calibration/lens/board.h"

#include "calibration/lens/find_board.h"
#include "core/printable.h"

#include <charconv>

namespace alltact {

double Board::diagonal_mm() const {
  return square_mm * std::hypot(columns - 1, rows - 1);
}

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
      return Error{en::say("'{}' is no board; it takes two counts from 3 to 100", printable(text)),
                   std::string("--board"),
                   en::say("9x6 for nine inner corners in a row and six rows")};
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
    return Error{
        en::say("the board finder gave up: {}", problem.err), "", en::say("another picture")};
  }
}

Eigen::Vector2d oriented_pixel(const Eigen::Vector2d& pixel,
                               cv::Size raw,
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

}  // namespace alltact
