// Boards of a live picture: which of its frames are worth keeping as views of a lens calibration.
#pragma once

#include "calibration/lens/board.h"
#include "core/frame.h"

#include <array>
#include <optional>
#include <vector>

namespace alltact {

/// What one frame shows of the board.
struct BoardLook {
  FramePtr frame;
  std::optional<BoardView> view;  ///< none: no board was found
  Message why_none;
  bool is_new = false;    ///< no kept view shows the board so
  bool is_still = false;  ///< as in the look before
  bool is_sharp = false;
  [[nodiscard]] bool is_worth_keeping() const { return view && is_new && is_still && is_sharp; }
};

/// One thread.
class BoardCollector {
 public:
  static constexpr int kColumns = 6, kRows = 4;  ///< cells of the picture, as LensCoverage has them
  static constexpr double kNew_part =
      0.05;                                 ///< of the picture's width: how far corners must differ
  static constexpr double kStill_px = 1.5;  ///< median way of a corner between two looks
  static constexpr double kSharp_px = 4;    ///< BoardView::edge_px

  explicit BoardCollector(const Board& board) : board_(board) {}
  [[nodiscard]] const Board& board() const { return board_; }

  /// Looks for the board in a frame as the camera gave it: some hundredths of a second, more where
  /// there is none.
  [[nodiscard]] BoardLook look(const FramePtr& frame);
  /// Keeps a look's view, under the name "board_01" and so on, which its frame is given, too.
  void keep(BoardLook look);

  /// Takes a kept view away again; its name is not used anew.
  void forget(const std::string& name);

  [[nodiscard]] const std::vector<BoardView>& views() const { return views_; }
  [[nodiscard]] const std::vector<FramePtr>& frames() const { return frames_; }
  /// Corners of kept views in each cell, rows from the top.
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
