// A camera's controls: listing, reading, writing, and locking those that change brightness.
#pragma once

#include "core/base/result.h"
#include "core/devices/v4l2_device.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace alltact {

enum class ControlType { kInteger = 1, kBoolean, kMenu, kIntegerMenu, kButton, kBitmask, kOther };
[[nodiscard]] std::string_view to_string(ControlType type);

struct MenuItem {
  std::int64_t value = 0;
  std::string name;
};

struct CameraControl {
  std::uint32_t id = 0;
  std::string name;
  ControlType type = ControlType::kOther;
  std::int64_t low = 0, high = 0, step = 1, default_value = 0;
  std::int64_t value = 0;      ///< at the time of the listing; 0 where it cannot be read
  std::vector<MenuItem> menu;  ///< kMenu, kIntegerMenu: the choices
  bool is_read_only = false;
  bool is_inactive = false;  ///< an automatic mode controls it

  /// True for a value that can be stored and restored.
  [[nodiscard]] bool is_setting() const {
    return !is_read_only && type != ControlType::kButton && type != ControlType::kOther;
  }
};

/// One control as it is stored with a finger.
struct ControlValue {
  std::uint32_t id = 0;
  std::string name;
  std::int64_t value = 0;
  bool operator==(const ControlValue&) const = default;
};

/// The value of this control; null where there is none.
[[nodiscard]] ControlValue* find_control(std::vector<ControlValue>& values, std::uint32_t id);
/// Replaces known values by `updates` and adds new ones; ordered by id, as drivers list them.
void merge_controls(std::vector<ControlValue>& values, const std::vector<ControlValue>& updates);

[[nodiscard]] std::vector<CameraControl> list_controls(const V4l2Device& device);
[[nodiscard]] Result<std::int64_t> read_control(const V4l2Device& device,
                                                const ControlValue& control);
/// Error: refused, out of range, or the camera set another value.
[[nodiscard]] Status write_control(const V4l2Device& device, const ControlValue& control);

/// All current settings of a camera, without those that an automatic mode controls.
[[nodiscard]] std::vector<ControlValue> settings_of(const std::vector<CameraControl>& controls);

/// Restores values, automatic modes first, because they decide which others are writable. Returns a
/// sentence, without its full stop, for each failure.
[[nodiscard]] std::vector<Message> restore_controls(const V4l2Device& device,
                                                    const std::vector<ControlValue>& requested);

/// Switches off every automatic mode of exposure, gain, white balance and focus. Returns the values
/// to hold from now on: these modes and their values. `problems` receives a sentence, without its
/// full stop, for each automatic mode that cannot be switched off.
[[nodiscard]] std::vector<ControlValue> lock_brightness(const V4l2Device& device,
                                                        std::vector<Message>& problems);

/// Automatic modes of exposure, gain, white balance and focus that are on according to `controls`.
/// With one of them on, the camera changes brightness or sharpness by itself.
[[nodiscard]] std::vector<CameraControl> automatic_modes_on(
    const std::vector<CameraControl>& controls);

/// Subscribes to changes by other programs and by the camera itself (POLLPRI, then next_change()):
/// of controls, and of the signal. Drivers without events are polled instead.
void watch_changes(const V4l2Device& device, const std::vector<CameraControl>& controls);
/// The camera's signal differs from the negotiated format (V4L2_EVENT_SOURCE_CHANGE).
struct SourceChange {};
/// The next reported change; empty when there is none. A control comes without its name.
[[nodiscard]] std::optional<std::variant<ControlValue, SourceChange>> next_change(
    const V4l2Device& device);

}  // namespace alltact
