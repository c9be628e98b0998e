// A pedal or dimmer in a made-up /dev. Only for programs that run under umockdev's preload library.
#pragma once

#include "tests/rigs/test_bed.h"

#include <chrono>
#include <cstring>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace alltact::test {

/// The kernel's half of a made-up /dev/hidrawNUMBER: its ioctls, and reports both ways.
class HidDevice {
 public:
  using Report = std::vector<std::uint8_t>;

  explicit HidDevice(TestBed& bed, int number = 0)
      : bed_(bed),
        node_("/dev/hidraw" + std::to_string(number)),
        handler_(umockdev_ioctl_base_new()) {
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&HidDevice::on_ioctl), this);
    GError* error = nullptr;
    if (umockdev_testbed_attach_ioctl(bed_.get(), node_.c_str(), handler_, &error) == 0)
      throw std::runtime_error(error->message);
    descriptor_ = umockdev_testbed_get_dev_fd(bed_.get(), node_.c_str());
    ::fcntl(descriptor_, F_SETFD, FD_CLOEXEC);  // a program under test must not hold both ends
    termios raw{};
    tcgetattr(descriptor_, &raw);
    cfmakeraw(&raw);
    tcsetattr(descriptor_, TCSANOW, &raw);
  }
  ~HidDevice() {
    umockdev_testbed_detach_ioctl(bed_.get(), node_.c_str(), nullptr);
    g_object_unref(handler_);
  }
  HidDevice(const HidDevice&) = delete;
  HidDevice& operator=(const HidDevice&) = delete;

  /// Whoever has it open gets an error from now on; nothing else may be done with it.
  void hang_up() { ::close(descriptor_); }
  void say(const Report& report) const {
    ASSERT_EQ(::write(descriptor_, report.data(), report.size()),
              static_cast<ssize_t>(report.size()));
    // Two reports at once would merge into one on this kind of node.
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  [[nodiscard]] Report hear() const {
    Report report(4096);
    const auto size = ::read(descriptor_, report.data(), report.size());
    report.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return report;
  }
  [[nodiscard]] Report feature() {
    const std::lock_guard lock(mutex_);
    return feature_;
  }

 private:
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<HidDevice*>(self)->answer(client);
  }
  gboolean answer(UMockdevIoctlClient* client) {
    static constexpr std::uint8_t kDescriptor[] = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0xC0};
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
    const std::size_t bytes = _IOC_SIZE(request);
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, bytes, nullptr);
    glong result = 0;
    if (request == HIDIOCGRDESCSIZE) {
      int size = sizeof kDescriptor;
      umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(&size), sizeof size);
    } else if (request == HIDIOCGRDESC) {
      hidraw_report_descriptor descriptor{};
      descriptor.size = sizeof kDescriptor;
      std::memcpy(descriptor.value, kDescriptor, sizeof kDescriptor);
      umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(&descriptor),
                                 sizeof descriptor);
    } else if (_IOC_TYPE(request) == 'H' && _IOC_NR(request) == 0x06) {  // HIDIOCSFEATURE
      const std::lock_guard lock(mutex_);
      feature_.assign(data->data, data->data + data->data_len);
      result = static_cast<glong>(bytes);
    } else {
      umockdev_ioctl_client_complete(client, -1, ENOTTY);
      return TRUE;
    }
    umockdev_ioctl_client_complete(client, result, 0);
    return TRUE;
  }

  TestBed& bed_;
  std::string node_;
  UMockdevIoctlBase* handler_;
  int descriptor_ = -1;
  std::mutex mutex_;
  Report feature_;
};

}  // namespace alltact::test
