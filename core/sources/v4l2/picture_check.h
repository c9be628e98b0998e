// What a camera says of its pictures, held against what can be.
#pragma once

#include "core/frame.h"

#include <cstdint>

namespace alltact {

/// One camera's pictures, in the order in which they came. Not for several threads at once.
class PictureCheck {
 public:
  struct Told {
    std::int64_t time_ns = 0;  ///< after that of the picture before, and not ahead of arrival
    std::int64_t late_ns = 0;  ///< what the camera's own time was off by; 0 where it counts
  };

  /// When a picture was taken. `told_ns` is what the camera says, by the clock of `arrived_ns`.
  /// Where that is not after the picture before, or more than 0.1 s ahead, the arrival counts.
  [[nodiscard]] Told time_of(std::int64_t told_ns, std::int64_t arrived_ns);

  /// The picture is the one before once more, to the last bit, which noise allows no camera.
  /// Numbers and times are no sign: some drivers never change them. Nor is one brightness all over:
  /// a lens cap gives that again and again.
  [[nodiscard]] bool is_repeat(const FramePtr& frame);

 private:
  FramePtr last_;
  std::int64_t last_time_ns_ = 0;
};

}  // namespace alltact
