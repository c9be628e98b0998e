#include "core/devices/hot_plug.h"

#include <string_view>

#include <libudev.h>

namespace alltact {

std::unique_ptr<HotPlug> HotPlug::watch() {
  udev* context = udev_new();
  if (context == nullptr) return nullptr;
  // "udev", not "kernel": its events come when links and access rights exist.
  udev_monitor* monitor = udev_monitor_new_from_netlink(context, "udev");
  if (monitor == nullptr) {
    udev_unref(context);
    return nullptr;
  }
  std::unique_ptr<HotPlug> plug(new HotPlug(context, monitor));
  for (const char* subsystem : {"video4linux", "hidraw"})
    udev_monitor_filter_add_match_subsystem_devtype(monitor, subsystem, nullptr);
  if (udev_monitor_enable_receiving(monitor) < 0) return nullptr;
  return plug;
}

HotPlug::~HotPlug() {
  udev_monitor_unref(monitor_);
  udev_unref(context_);
}

int HotPlug::descriptor() const { return udev_monitor_get_fd(monitor_); }

std::vector<HotPlug::Event> HotPlug::read() {
  std::vector<Event> events;
  while (udev_device* device = udev_monitor_receive_device(monitor_)) {
    const char* action = udev_device_get_action(device);
    const char* node = udev_device_get_devnode(device);
    if (action != nullptr && node != nullptr)
      events.push_back({std::string_view(action) == "add", node});
    udev_device_unref(device);
  }
  return events;
}

}  // namespace alltact
