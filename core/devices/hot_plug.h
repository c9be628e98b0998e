// Events of devices that are plugged in and removed.
#pragma once

#include <memory>
#include <string>
#include <vector>

struct udev;
struct udev_monitor;

namespace alltact {

/// One thread.
class HotPlug {
 public:
  /// Watches cameras and HID devices; null where the system has no udev.
  static std::unique_ptr<HotPlug> watch();
  ~HotPlug();
  HotPlug(const HotPlug&) = delete;
  HotPlug& operator=(const HotPlug&) = delete;

  struct Event {
    bool is_added = false;  ///< else removed or changed
    std::string node;       ///< /dev/video0
  };
  /// Readable when there are events.
  [[nodiscard]] int descriptor() const;
  /// All pending events; does not wait.
  [[nodiscard]] std::vector<Event> read();

 private:
  HotPlug(udev* context, udev_monitor* monitor) : context_(context), monitor_(monitor) {}
  udev* context_;
  udev_monitor* monitor_;
};

}  // namespace alltact
