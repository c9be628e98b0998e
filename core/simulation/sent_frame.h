// A simulated frame after transport from the camera.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct SentFrame {
  cv::Mat grey;
  /// The packet; null unless the scene has mjpeg.
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
};

/// Whether and when a frame arrives.
struct Arrival {
  bool is_dropped = false;  ///< it never arrives
  double late_ms = 0;       ///< delay
};

}  // namespace alltact
