// The boards in all pictures of a source.
#pragma once

#include "calibration/lens/board.h"
#include "core/camera/camera.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sources/source.h"

#include <utility>
#include <vector>

namespace alltact {

struct LensViews {
  std::vector<BoardView> views;                    ///< pixels of the pictures after orientation
  cv::Size size;                                   ///< of the pictures after orientation
  std::vector<std::pair<Where, Message>> refused;  ///< picture, and why
  std::size_t looked_at = 0;  ///< of a long recording not every picture is looked at
  std::size_t repeats = 0;    ///< of a long recording, pictures that show a board once more
};

/// Of a recording at most this many pictures are looked at, evenly; and of these only such are kept
/// that show the board in another place.
inline constexpr std::size_t kMostPictures = 300;

/// Looks for the board in every picture, in the raw one: a mirror would spoil markers. Errors:
/// pictures of different sizes, no board in any of them (with the size of the one that is there,
/// where that can be told), two pictures of one name, stopped.
[[nodiscard]] Result<LensViews> find_boards(Source& source,
                                            const Board& board,
                                            Orientation orientation,
                                            const Job& job);

}  // namespace alltact
