// One picture as it came from wherever pictures come from.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// An immutable grey picture. `grey` is 8-bit, one channel, rows = height, as the source gave it
/// (not yet turned by camera.orientation); nobody may write to it.
struct Frame {
  cv::Mat grey;
  /// The camera's own compressed picture, one whole JPEG, where the camera sends such; else null.
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
  std::string name;            ///< file name without its ending, or frame_00000 through a video
  std::string origin;          ///< where it came from, for messages: a path or a device
  std::uint64_t sequence = 0;  ///< counts from 0 in the order of the source, gaps are lost frames
  std::int64_t time_ns = 0;    ///< monotonic clock of capture; 0 when the source has none
  /// What camera and light were set to (see frame_settings.h); null where the source tells nothing.
  std::shared_ptr<const std::string> controls;
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace alltact
