// A simulated picture at the end of its way from the camera.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct SentPicture {
  cv::Mat grey;
  /// The packet that it came in; null unless the scene names mjpeg.
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
};

/// Whether and when a picture comes.
struct Arrival {
  bool is_dropped = false;  ///< it never does
  double late_ms = 0;       ///< after its time
};

}  // namespace alltact
