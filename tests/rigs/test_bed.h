// A made-up /sys, /dev and udev (umockdev), with a camera's and a pedal's entries. Only for
// programs that run under umockdev's preload library.
#pragma once

#include <string>
#include <vector>

#include <umockdev.h>

namespace alltact::test {

class TestBed {
 public:
  TestBed() : bed_(umockdev_testbed_new()) {}
  ~TestBed() { g_object_unref(bed_); }
  TestBed(const TestBed&) = delete;
  TestBed& operator=(const TestBed&) = delete;

  /// Device entries as umockdev-record writes them.
  void add(const std::string& text) {
    GError* error = nullptr;
    if (umockdev_testbed_add_from_string(bed_, text.c_str(), &error) == 0)
      throw std::runtime_error(error->message);
  }
  /// Both with the path as in the entry ("/devices/...").
  void tell_added(const std::string& path) {
    umockdev_testbed_uevent(bed_, ("/sys" + path).c_str(), "add");
  }
  void remove(const std::string& path) {
    const std::string sys_path = "/sys" + path;
    umockdev_testbed_uevent(bed_, sys_path.c_str(), "remove");
    umockdev_testbed_remove_device(bed_, sys_path.c_str());
  }
  [[nodiscard]] UMockdevTestbed* get() const { return bed_; }

  /// A camera node; `number` counts nodes, `serial` is also part of its names.
  static std::string camera(int number, const std::string& serial, int port, int index = 0) {
    const std::string n = std::to_string(number), p = std::to_string(port),
                      i = std::to_string(index);
    const std::string id = "usb-Fake_Camera_" + serial + "-video-index" + i;
    const std::string path = "pci-0000:00:14.0-usb-0:" + p + ":1.0-video-index" + i;
    return "P: " + camera_path(number, port) + "\nN: video" + n +
           "\nE: SUBSYSTEM=video4linux\nE: DEVNAME=/dev/video" + n +
           "\nE: MAJOR=81\nE: MINOR=" + n + "\nE: ID_SERIAL_SHORT=" + serial +
           "\nE: DEVLINKS=/dev/v4l/by-id/" + id + " /dev/v4l/by-path/" + path +
           "\nA: name=Fake Camera\\n\nA: dev=81:" + n + "\\n\nA: index=0\\n\n\n";
  }
  static std::string camera_path(int number, int port) {
    return "/devices/pci/usb1/1-" + std::to_string(port) + "/video4linux/video" +
           std::to_string(number);
  }

  /// A USB HID device with one node, /dev/hidrawNUMBER.
  static std::string hid(int number, const std::string& vendor, const std::string& product,
                         const std::string& name) {
    const std::string n = std::to_string(number);
    const std::string usb = "/devices/pci/usb1/2-" + n, interface = usb + "/2-" + n + ":1.0";
    const std::string hid = interface + "/0003:" + vendor + ":" + product + ".000" + n;
    return "P: " + usb + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + vendor +
           "\\n\nA: idProduct=" + product + "\\n\nA: product=" + name +
           "\\n\nA: manufacturer=Fake\\n\nA: bcdDevice=0100\\n\n\nP: " + interface +
           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\\n\n\nP: " + hid +
           "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:0000" + vendor + ":0000" + product +
           "\nE: HID_NAME=" + name + "\nE: HID_UNIQ=\n\nP: " + hid + "/hidraw/hidraw" + n +
           "\nN: hidraw" + n + "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw" + n +
           "\nE: MAJOR=240\nE: MINOR=" + n + "\nA: dev=240:" + n + "\\n\n\n";
  }

  /// With everything above its node.
  void remove_hid(int number, const std::string& vendor, const std::string& product) {
    const std::string n = std::to_string(number);
    const std::string usb = "/devices/pci/usb1/2-" + n, interface = usb + "/2-" + n + ":1.0";
    const std::string hid = interface + "/0003:" + vendor + ":" + product + ".000" + n;
    for (const std::string& path : {hid + "/hidraw/hidraw" + n, hid, interface, usb}) remove(path);
  }

 private:
  UMockdevTestbed* bed_;
};

}  // namespace alltact::test
