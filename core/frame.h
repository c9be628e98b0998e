// One frame of a camera, a video, an image file or a simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// An immutable grey image. `grey` is 8-bit, one channel, rows = height, in the source's
/// orientation (before camera.orientation is applied). Nobody may write to it.
struct Frame {
  cv::Mat grey;
  /// The camera's own compressed image, one complete JPEG; null where the camera sends none.
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
  std::string name;            ///< file name without its extension, or frame_00000 for a video
  std::string origin;          ///< origin for messages: a path or a device
  std::uint64_t sequence = 0;  ///< counts from 0 in the source's order; gaps are lost frames
  std::int64_t time_ns = 0;    ///< monotonic clock of the capture, ns; 0: the source has none
  /// Settings of camera and light (see frame_settings.h); null where the source reports none.
  std::shared_ptr<const std::string> controls;
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace alltact
