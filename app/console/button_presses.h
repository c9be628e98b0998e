// Presses of a foot pedal or button while a command runs, and its problems.
#pragma once

#include "app/console/console.h"
#include "core/result.h"
#include "core/sources/hid/hid_button.h"

#include <atomic>
#include <memory>

namespace alltact {

/// One thread asks; the presses arrive on another.
class ButtonPresses {
 public:
  /// Errors: the device is not there, or may not be used (with the udev rule to install).
  [[nodiscard]] static Result<std::unique_ptr<ButtonPresses>> listen(const LearntButton& button);

  /// True when it was pressed since the last call. Warns once when the device was unplugged, waits
  /// for it, and reports its return.
  [[nodiscard]] bool taken(Console& console);
  /// Drops presses that came before now.
  void forget() { presses_ = 0; }

 private:
  ButtonPresses(std::unique_ptr<HidPort> port, const LearntButton& button);

  std::atomic<int> presses_{0};
  bool is_away_ = false;
  HidButton button_;  // last: its thread ends first
};

}  // namespace alltact
