// Boards in a live stream: which of its frames are useful views for a lens calibration.
#pragma once

#include "calibration/lens/board.h"
#include "core/frame.h"

#include <array>
#include <optional>
#include <vector>

namespace alltact {

/// The board in one frame.
struct BoardAnalysis {
  FramePtr frame;
  std::optional<BoardView> view;  ///< empty: no board was found
  Message no_board_reason;
  bool is_new = false;    ///< no stored view shows the board like this
  bool is_still = false;  ///< as in the previous frame
  bool is_sharp = false;
  [[nodiscard]] bool is_useful() const { return view && is_new && is_still && is_sharp; }
};

/// Not thread-safe.
class BoardCollector {
 public:
  static constexpr int kColumns = 6, kRows = 4;  ///< cells of the image, as in LensCoverage
  static constexpr double kNew_part =
      0.05;  ///< of the image width: smallest median difference of corners
  static constexpr double kStill_px = 1.5;  ///< largest median shift of a corner between two frames
  static constexpr double kSharp_px = 4;    ///< BoardView::edge_px

  explicit BoardCollector(const Board& board) : board_(board) {}
  [[nodiscard]] const Board& board() const { return board_; }

  /// Searches the board in a raw camera frame: some hundredths of a second, more where there is
  /// none.
  [[nodiscard]] BoardAnalysis analyse(const FramePtr& frame);
  /// Stores a view; view and frame receive the names "board_01" and so on.
  void add(BoardAnalysis analysis);

  /// Removes a stored view; its name is not used again.
  void forget(const std::string& name);

  [[nodiscard]] const std::vector<BoardView>& views() const { return views_; }
  [[nodiscard]] const std::vector<FramePtr>& frames() const { return frames_; }
  /// Corners of stored views in each cell, rows from the top.
  using Cells = std::array<std::array<int, kColumns>, kRows>;
  [[nodiscard]] Cells cells() const;

 private:
  Board board_;
  std::optional<BoardView> last_;
  std::vector<BoardView> views_;
  std::vector<FramePtr> frames_;
  int named_ = 0;
};

}  // namespace alltact
