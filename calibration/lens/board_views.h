// Views of a board: from the frames of a live stream, and from all images of a source.
#pragma once

#include "calibration/lens/board.h"
#include "calibration/lens/marker_board.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/image/frame.h"
#include "core/sources/source.h"

#include <array>
#include <optional>
#include <utility>
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

  explicit BoardCollector(const Board& board) : board_(board), recogniser_(board) {}
  /// With its print, once a frame has shown it.
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
  /// Counts a corner of an image of this size.
  static void add_corner(const Eigen::Vector2d& pixel, cv::Size size, Cells& cells);
  [[nodiscard]] Cells cells() const;

 private:
  /// Recognises the print of a board with markers. False with the reason: not yet.
  Status recognise(const cv::Mat& grey);

  Board board_;
  MarkerPrintRecogniser recogniser_;
  std::optional<BoardView> last_;
  std::vector<BoardView> views_;
  std::vector<FramePtr> frames_;
  int named_ = 0;
};

// The boards in all images of a source.

struct LensViews {
  std::vector<BoardView> views;                    ///< pixels of the oriented images
  cv::Size size;                                   ///< of the oriented images
  std::vector<std::pair<Where, Message>> refused;  ///< image, and the reason
  std::size_t analysed = 0;  ///< of a long recording only some images are analysed
  std::size_t repeats = 0;   ///< of a long recording, images that repeat a view
  Board board;               ///< with the print that the images show
};

/// At most this many images of a recording are analysed, evenly spread. Only those that show the
/// board in another pose are retained.
inline constexpr std::size_t kMaxImages = 300;

/// Searches the board in every raw image: a mirrored one would spoil markers. Errors: images of
/// different sizes, no board in any of them (with the actual pattern and size where they are
/// found), markers of another dictionary or board, two images of one name, stopped.
[[nodiscard]] Result<LensViews> find_boards(Source& source, const Board& board,
                                            Orientation orientation, const Job& job);

}  // namespace alltact
