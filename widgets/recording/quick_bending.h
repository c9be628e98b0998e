// Whether a finger bends so quickly that its picture cannot be held against any other: then what
// looks like a touch may be the movement.
#pragma once

#include "core/sensing/pipeline.h"

#include <string>

namespace alltact {

/// Fed with every frame that is looked at. A source that tells no times is timed as it comes.
class QuickBending {
 public:
  /// Markers that move by more than this part of the picture's width in a second bend quickly.
  static constexpr double kQuick_per_s = 0.08;
  /// How long after that the picture is not trusted yet.
  static constexpr double kSettles_s = 0.4;

  /// False where no speed can be told: the first frame, no markers, another source.
  bool is_quick(const FrameResult& result);

 private:
  Markers before_;
  double before_s_ = 0;
  double quick_until_s_ = -1;
  std::string source_;
};

}  // namespace alltact
