// Reads a source for a command that records it.
#pragma once

#include "app/console/button_presses.h"
#include "app/console/camera_remarks.h"
#include "app/console/console.h"
#include "core/message.h"
#include "core/sources/source.h"

#include <string>

namespace alltact {

/// Prints each fault and each remark of the camera once, and takes button presses between frames.
class SourceReader {
 public:
  SourceReader(Source& source, CameraRemarks remarks, ButtonPresses* button, Console& console)
      : source_(source), remarks_(std::move(remarks)), button_(button), console_(console) {}

  /// The next frame; null when the source is over, with the reason in why(), or when the button was
  /// pressed while no frame came.
  FramePtr next() {
    while (true) {
      if (is_stopped()) return end(en::say("stopped by hand"));
      auto frame = source_.next();
      remarks_.report(console_);
      is_pressed_ = button_ != nullptr && button_->taken(console_);
      if (frame && *frame) {
        last_problem_.clear();
        return *frame;
      }
      if (frame)
        return end(is_stopped() ? en::say("stopped by hand") : en::say("the source ended"));
      // An unplugged camera reports the same error again and again, and may come back.
      const std::string problem = frame.error().sentence();
      if (problem != last_problem_) console_.warn(problem);
      last_problem_ = problem;
      ++unreadable_;
      if (is_pressed_) return nullptr;
    }
  }
  /// The button was pressed since the call of next() before the last.
  [[nodiscard]] bool is_pressed() const { return is_pressed_; }
  /// Empty as long as frames may follow.
  [[nodiscard]] const Message& why() const { return why_; }
  [[nodiscard]] bool is_over() const { return !why_.empty(); }
  [[nodiscard]] bool is_stopped() const { return console_.job().stop_requested(); }
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }
  [[nodiscard]] Source& source() const { return source_; }

 private:
  FramePtr end(Message why) {
    why_ = std::move(why);
    return nullptr;
  }

  Source& source_;
  CameraRemarks remarks_;
  ButtonPresses* button_;
  Console& console_;
  bool is_pressed_ = false;
  Message why_;
  std::string last_problem_;
  std::uint64_t unreadable_ = 0;
};

}  // namespace alltact
