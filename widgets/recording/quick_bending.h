// Detects bending too quick for the image to be compared with the reference: motion then resembles
// a contact.
#pragma once

#include "core/sensing/pipeline.h"

#include <string>

namespace alltact {

/// Call it with every analysed frame. Frames without capture times are timed on arrival.
class QuickBending {
 public:
  /// Marker speed above which bending is quick, in image widths per second.
  static constexpr double kQuick_per_s = 0.08;
  /// Time after quick motion during which the image is not used.
  static constexpr double kSettles_s = 0.4;

  /// Returns false where the speed is unknown: the first frame, no markers, another source.
  bool is_quick(const FrameResult& result);

 private:
  Markers before_;
  double before_s_ = 0;
  double quick_until_s_ = -1;
  std::string source_;
};

}  // namespace alltact
