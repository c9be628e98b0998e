// Settings of camera and light as text, which every frame carries:
//   Camera=usb-Maker_Model_SERIAL-video-index0; Format=1920x1080 MJPG at 30 frames per second;
//   Gain=3
// The same text goes from the camera through the journal or the image file into finger.yaml.
#pragma once

#include "core/frame.h"
#include "core/message.h"

#include <string>
#include <string_view>

namespace alltact {

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
