// HID devices: which there are, and reports to and from one of them.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alltact {

struct HidIdentity {
  std::string node;  ///< /dev/hidraw0: may be another after the next start
  std::uint16_t vendor = 0, product = 0;
  std::string serial, name;
  int interface = -1;  ///< of a device with several, else -1

  /// "0c45:7403", with ":SERIAL" and "/INTERFACE" where it has them: lasts.
  [[nodiscard]] std::string lasting() const;
};

struct FoundHid {
  HidIdentity identity;
  std::optional<Error> problem;  ///< why it cannot be used: mostly a missing udev rule
};

/// Every HID device, in the order of nodes.
[[nodiscard]] std::vector<FoundHid> list_hids();

/// An open device, or a rig's. One thread. Reports begin with their id where the device numbers
/// them; what is sent begins with the id always, 0 where there are no ids.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// The next input report; empty when none came within the time. Error: unplugged.
  [[nodiscard]] virtual Result<std::vector<std::uint8_t>> read(int timeout_ms) = 0;
  [[nodiscard]] virtual Status write(std::span<const std::uint8_t> report) = 0;
  [[nodiscard]] virtual Status send_feature(std::span<const std::uint8_t> report) = 0;
};

/// wanted: a node, vendor:product, a whole lasting() name, or a serial number; of several
/// interfaces the first. Errors: not there, with what there is; access not allowed, with the udev
/// rule.
[[nodiscard]] Result<std::unique_ptr<HidPort>> open_hid(const std::string& wanted);

}  // namespace alltact
