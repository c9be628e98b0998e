// News of devices that come and go.
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

  struct News {
    bool is_added = false;  ///< else removed or changed
    std::string node;       ///< /dev/video0
  };
  /// Readable when there is news.
  [[nodiscard]] int descriptor() const;
  /// All news that is there; does not wait.
  [[nodiscard]] std::vector<News> read();

 private:
  HotPlug(udev* context, udev_monitor* monitor) : context_(context), monitor_(monitor) {}
  udev* context_;
  udev_monitor* monitor_;
};

}  // namespace alltact
