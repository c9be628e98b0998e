#include "core/devices/hid_port.h"

#include "core/base/result.h"

#include <cerrno>
#include <cstring>
#include <mutex>

#include <hidapi/hidapi.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr std::size_t kLongestReport = 4096;

/// hidapi's functions for listing and opening share state.
std::mutex& hidapi_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string narrow(const wchar_t* text) {
  std::string narrow;
  for (; text != nullptr && *text != 0; ++text)
    narrow += *text > 31 && *text < 127 ? static_cast<char>(*text) : '?';
  return narrow;
}

Error no_access(const HidIdentity& identity, int error_number) {
  if (error_number != EACCES && error_number != EPERM)
    return errno_error(en::say("the device cannot be opened"), identity.node,
                       {{}, en::say("unplug it and plug it in again")}, error_number);
  return {en::say("access to the device is not allowed"),
          fmt::format("{} ({})", identity.node, identity.stable_name()),
          en::say("install packaging/70-alltact.rules in /etc/udev/rules.d and plug it in "
                  "again; a device it does not name needs this line in it: KERNEL==\"hidraw*\", "
                  "ATTRS{{idVendor}}==\"{:04x}\", ATTRS{{idProduct}}==\"{:04x}\", "
                  "TAG+=\"uaccess\"",
                  identity.vendor, identity.product)};
}

Error unplugged(const std::string& name) {
  return {en::say("the device was unplugged"), name, en::say("plug it in again")};
}

class HidapiPort : public HidPort {
 public:
  HidapiPort(hid_device* device, std::string name) : device_(device), name_(std::move(name)) {}
  ~HidapiPort() override { hid_close(device_); }
  HidapiPort(const HidapiPort&) = delete;
  HidapiPort& operator=(const HidapiPort&) = delete;

  Result<std::vector<std::uint8_t>> read(int timeout_ms) override {
    std::vector<std::uint8_t> report(kLongestReport);
    const int size = hid_read_timeout(device_, report.data(), report.size(), timeout_ms);
    if (size < 0) return unplugged(name_);
    report.resize(static_cast<std::size_t>(size));
    return report;
  }
  Status write(std::span<const std::uint8_t> report) override {
    return sent(hid_write(device_, report.data(), report.size()));
  }
  Status send_feature(std::span<const std::uint8_t> report) override {
    return sent(hid_send_feature_report(device_, report.data(), report.size()));
  }

 private:
  [[nodiscard]] Status sent(int size) const {
    if (size >= 0) return {};
    return Error{en::say("the device refused the report"), name_,
                 en::say("plug it in again, and check its description")};
  }

  hid_device* device_;
  std::string name_;
};

bool matches(const HidIdentity& identity, const std::string& requested) {
  const std::string stable_name = identity.stable_name();
  const std::string pair = fmt::format("{:04x}:{:04x}", identity.vendor, identity.product);
  const std::string without_interface = stable_name.substr(0, stable_name.rfind('/'));
  return !requested.empty() &&
         (requested == identity.node || requested == identity.serial || requested == stable_name ||
          requested == pair || requested == without_interface);
}

}  // namespace

std::string HidIdentity::stable_name() const {
  std::string text = fmt::format("{:04x}:{:04x}", vendor, product);
  if (!serial.empty()) text += ":" + serial;
  if (interface >= 0) text += fmt::format("/{}", interface);
  return text;
}

std::vector<FoundHid> list_hids() {
  std::vector<FoundHid> found;
  const std::lock_guard lock(hidapi_mutex());
  hid_device_info* all = hid_enumerate(0, 0);
  for (const hid_device_info* info = all; info != nullptr; info = info->next) {
    FoundHid hid;
    hid.identity.node = info->path;
    hid.identity.vendor = info->vendor_id;
    hid.identity.product = info->product_id;
    hid.identity.serial = narrow(info->serial_number);
    hid.identity.name = narrow(info->product_string);
    hid.identity.interface = info->interface_number;
    // hidapi lists a device with several uses once for each.
    if (!found.empty() && found.back().identity.node == hid.identity.node) continue;
    if (access(info->path, R_OK | W_OK) != 0) hid.problem = no_access(hid.identity, errno);
    found.push_back(std::move(hid));
  }
  hid_free_enumeration(all);
  std::sort(found.begin(), found.end(), [](const FoundHid& a, const FoundHid& b) {
    return std::pair(a.identity.node.size(), a.identity.node) <
           std::pair(b.identity.node.size(), b.identity.node);
  });
  return found;
}

Result<std::unique_ptr<HidPort>> open_hid(const std::string& requested) {
  const auto hids = list_hids();
  std::vector<Message> names;
  for (const FoundHid& hid : hids) {
    const HidIdentity& identity = hid.identity;
    if (!matches(identity, requested)) {
      names.push_back(
          Message::typed(fmt::format("{} ({})", identity.stable_name(), identity.name)));
      continue;
    }
    if (hid.problem) return *hid.problem;
    const std::lock_guard lock(hidapi_mutex());
    hid_device* device = hid_open_path(identity.node.c_str());
    if (device == nullptr) return no_access(identity, errno == 0 ? EIO : errno);
    return std::unique_ptr<HidPort>(std::make_unique<HidapiPort>(device, identity.stable_name()));
  }
  return Error{names.empty()
                   ? en::say("no HID device was found")
                   : en::say("there is no such HID device; available: {}", en::list(names)),
               requested, en::say("plug it in; 'alltact devices' lists what is found")};
}

}  // namespace alltact
