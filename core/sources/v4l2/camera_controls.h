// A camera's controls: what there is, reading and writing, holding those still that change
// brightness.
#pragma once

#include "core/result.h"
#include "core/sources/v4l2/v4l2_device.h"

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
  std::int64_t value = 0;      ///< when it was listed; 0 where it cannot be read
  std::vector<MenuItem> menu;  ///< kMenu, kIntegerMenu: what can be chosen
  bool is_read_only = false;
  bool is_inactive = false;  ///< an automatic mode has it in hand

  /// A value that can be stored and put back.
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

/// The one of this control; null where there is none.
[[nodiscard]] ControlValue* find_control(std::vector<ControlValue>& values, std::uint32_t id);
/// `news` take the place of what was known of them; ordered by id, as drivers list them.
void merge_controls(std::vector<ControlValue>& values, const std::vector<ControlValue>& news);

[[nodiscard]] std::vector<CameraControl> list_controls(const V4l2Device& device);
[[nodiscard]] Result<std::int64_t> read_control(const V4l2Device& device,
                                                const ControlValue& control);
/// Error: refused, out of range, or the camera kept another value.
[[nodiscard]] Status write_control(const V4l2Device& device, const ControlValue& control);

/// All settings of a camera as they are. Those that an automatic mode has in hand are left out.
[[nodiscard]] std::vector<ControlValue> settings_of(const std::vector<CameraControl>& controls);

/// Writes them back, automatic modes first, because they decide what else can be written. Returns a
/// sentence, without its full stop, for each that could not be.
[[nodiscard]] std::vector<Message> put_back(const V4l2Device& device,
                                            const std::vector<ControlValue>& wanted);

/// Switches off every automatic mode of exposure, gain, white balance and focus, and gives what has
/// to stay as it is from now on: these modes and their values. `problems` gets a sentence, without
/// its full stop, for each automatic mode that cannot be switched off.
[[nodiscard]] std::vector<ControlValue> lock_brightness(const V4l2Device& device,
                                                        std::vector<Message>& problems);

/// Those automatic modes of exposure, gain, white balance and focus that are on, by the values of
/// `controls`: with one of them on, brightness or sharpness are the camera's own.
[[nodiscard]] std::vector<CameraControl> automatic_modes_on(
    const std::vector<CameraControl>& controls);

/// Asks to be told of changes that other programs and the camera itself make (POLLPRI, then
/// next_change()): of controls, and of what the camera sends. Drivers without events are read in
/// turn instead.
void watch_changes(const V4l2Device& device, const std::vector<CameraControl>& controls);
/// The camera sends pictures of another kind than was agreed on (V4L2_EVENT_SOURCE_CHANGE).
struct SourceChange {};
/// The next change that was told; empty when there is none. A control comes without its name.
[[nodiscard]] std::optional<std::variant<ControlValue, SourceChange>> next_change(
    const V4l2Device& device);

}  // namespace alltact
