// Lists HID devices, and exchanges reports with one of them.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alltact {

struct HidIdentity {
  std::string node;  ///< /dev/hidraw0: may change with the next start
  std::uint16_t vendor = 0, product = 0;
  std::string serial, name;
  int interface = -1;  ///< of a device with several interfaces, else -1

  /// "0c45:7403", with ":SERIAL" and "/INTERFACE" where they exist: stable over restarts.
  [[nodiscard]] std::string stable_name() const;
};

struct FoundHid {
  HidIdentity identity;
  std::optional<Error> problem;  ///< why it cannot be used: usually a missing udev rule
};

/// Every HID device, in the order of nodes.
[[nodiscard]] std::vector<FoundHid> list_hids();

/// An open device, or a simulated one of a test. One thread. Input reports begin with their id
/// where the device has ids; output reports always begin with the id, 0 where there are none.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// The next input report; empty: none came within the timeout. Error: unplugged.
  [[nodiscard]] virtual Result<std::vector<std::uint8_t>> read(int timeout_ms) = 0;
  [[nodiscard]] virtual Status write(std::span<const std::uint8_t> report) = 0;
  [[nodiscard]] virtual Status send_feature(std::span<const std::uint8_t> report) = 0;
};

/// requested: a node, vendor:product, a complete stable_name() name, or a serial number. Of several
/// interfaces the first one is opened. Errors: not there, with a list of devices; access not
/// allowed, with the udev rule.
[[nodiscard]] Result<std::unique_ptr<HidPort>> open_hid(const std::string& requested);

}  // namespace alltact
