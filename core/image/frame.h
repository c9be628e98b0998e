// One frame of a camera, a video, an image file or a simulation.
#pragma once

#include "core/base/message.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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
  /// Of the capture, ns: a camera's by the monotonic clock, a video's by its own. Empty: the source
  /// has none.
  std::optional<std::int64_t> time_ns;
  /// Settings of camera and light; null where the source reports none.
  std::shared_ptr<const std::string> controls;
};

using FramePtr = std::shared_ptr<const Frame>;

/// Time of capture in seconds; empty as Frame::time_ns.
[[nodiscard]] inline std::optional<double> time_s(const Frame& frame) {
  if (!frame.time_ns) return std::nullopt;
  return 1e-9 * static_cast<double>(*frame.time_ns);
}

// Settings of camera and light as text, which every frame carries:
//   Camera=usb-Maker_Model_SERIAL-video-index0; Format=1920x1080 MJPG at 30 frames per second;
//   Gain=3
// The same text goes from the camera through the journal or the image file into finger.yaml.

/// Appends one entry. Separators inside a name or value become blanks.
void add_setting(std::string& settings, std::string_view name, std::string_view value);

/// Returns "Gain was 3 and is 5, Focus was 200 and is 0" for entries that both texts have and that
/// differ; empty where none does.
[[nodiscard]] Message differences(std::string_view before, std::string_view now);

/// The settings of a recording, whose frames should all have the same.
class SettingsMonitor {
 public:
  void add(const Frame& frame);
  /// Settings of the first frame that has any; empty where none has.
  [[nodiscard]] const std::string& first() const { return first_; }
  /// The first change during the recording, in the words of differences(); empty where nothing
  /// changed.
  [[nodiscard]] const Message& change() const { return change_; }

 private:
  std::string first_;
  Message change_;
  std::shared_ptr<const std::string> last_;
};

}  // namespace alltact
