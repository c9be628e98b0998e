// The boards in all images of a source.
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
  std::vector<BoardView> views;                    ///< pixels of the oriented images
  cv::Size size;                                   ///< of the oriented images
  std::vector<std::pair<Where, Message>> refused;  ///< image, and the reason
  std::size_t analysed = 0;  ///< of a long recording only some images are analysed
  std::size_t repeats = 0;   ///< of a long recording, images that repeat a view
};

/// At most this many images of a recording are analysed, evenly spread. Only those that show the
/// board in another pose are retained.
inline constexpr std::size_t kMaxImages = 300;

/// Searches the board in every raw image: a mirrored one would spoil markers. Errors: images of
/// different sizes, no board in any of them (with the board's actual size where it is found), two
/// images of one name, stopped.
[[nodiscard]] Result<LensViews> find_boards(Source& source,
                                            const Board& board,
                                            Orientation orientation,
                                            const Job& job);

}  // namespace alltact
