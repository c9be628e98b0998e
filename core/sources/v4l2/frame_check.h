// Checks the times and the repetition of a camera's frames.
#pragma once

#include "core/frame.h"

#include <cstdint>

namespace alltact {

/// Frames of one camera, in the order of arrival. Not for several threads at once.
class FrameCheck {
 public:
  struct CaptureTime {
    std::int64_t time_ns = 0;        ///< after that of the frame before, and not ahead of arrival
    std::int64_t correction_ns = 0;  ///< correction of the camera's own time; 0 where that is valid
  };

  /// Returns the time of capture. `camera_ns` is the camera's own time, on the clock of
  /// `arrived_ns`. The arrival replaces it where it is not after the frame before, or more than 0.1
  /// s ahead.
  [[nodiscard]] CaptureTime time_of(std::int64_t camera_ns, std::int64_t arrived_ns);

  /// True for an exact repetition of the frame before, which noise makes impossible for a camera.
  /// Numbers and times are no evidence: some drivers never change them. A uniform frame is no
  /// repetition either, because a lens cap gives it again and again.
  [[nodiscard]] bool is_repeat(const FramePtr& frame);

 private:
  FramePtr last_;
  std::int64_t last_time_ns_ = 0;
};

}  // namespace alltact
