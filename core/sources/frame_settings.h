// What camera and light were set to, as every frame carries it in words:
//   Camera=usb-Maker_Model_SERIAL-video-index0; Format=1920x1080 MJPG at 30 frames per second;
//   Gain=3
// The same text goes from the camera through the journal or the picture into finger.yaml.
#pragma once

#include "core/frame.h"
#include "core/message.h"

#include <string>
#include <string_view>

namespace alltact {

/// Appends one entry. What would be taken for the end of a name or an entry becomes a blank.
void add_setting(std::string& settings, std::string_view name, std::string_view value);

/// "Gain was 3 and is 5, Focus was 200 and is 0": of the entries that both have, those that differ;
/// empty where none does.
[[nodiscard]] Message differences(std::string_view before, std::string_view now);

/// The settings of a recording, whose frames should all have the same.
class SettingsSeen {
 public:
  void add(const Frame& frame);
  /// Of the first frame that told any; empty where none did.
  [[nodiscard]] const std::string& first() const { return first_; }
  /// The first change on the way, as differences() tells it; empty where nothing changed.
  [[nodiscard]] const Message& change() const { return change_; }

 private:
  std::string first_;
  Message change_;
  std::shared_ptr<const std::string> last_;
};

}  // namespace alltact
