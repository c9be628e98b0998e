#include "core/devices/camera_controls.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <linux/videodev2.h>

namespace alltact {
namespace {

ControlType type_of(std::uint32_t type) {
  switch (type) {
    case V4L2_CTRL_TYPE_INTEGER:
    case V4L2_CTRL_TYPE_INTEGER64:
      return ControlType::kInteger;
    case V4L2_CTRL_TYPE_BOOLEAN:
      return ControlType::kBoolean;
    case V4L2_CTRL_TYPE_MENU:
      return ControlType::kMenu;
    case V4L2_CTRL_TYPE_INTEGER_MENU:
      return ControlType::kIntegerMenu;
    case V4L2_CTRL_TYPE_BUTTON:
      return ControlType::kButton;
    case V4L2_CTRL_TYPE_BITMASK:
      return ControlType::kBitmask;
    default:
      return ControlType::kOther;
  }
}

/// An automatic mode that changes brightness, and its value for off.
struct AutomaticMode {
  std::uint32_t id;
  std::int64_t off;
};

constexpr std::array kAutomaticModes{
    AutomaticMode{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL},
    AutomaticMode{V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0},
    AutomaticMode{V4L2_CID_AUTOGAIN, 0},
    AutomaticMode{V4L2_CID_AUTO_WHITE_BALANCE, 0},
    AutomaticMode{V4L2_CID_AUTO_N_PRESET_WHITE_BALANCE, V4L2_WHITE_BALANCE_MANUAL},
    AutomaticMode{V4L2_CID_FOCUS_AUTO, 0},
    AutomaticMode{V4L2_CID_AUTOBRIGHTNESS, 0},
    AutomaticMode{V4L2_CID_ISO_SENSITIVITY_AUTO, V4L2_ISO_SENSITIVITY_MANUAL},
};

constexpr std::array<std::uint32_t, 12> kBrightnessValues{V4L2_CID_EXPOSURE_ABSOLUTE,
                                                          V4L2_CID_EXPOSURE,
                                                          V4L2_CID_GAIN,
                                                          V4L2_CID_ANALOGUE_GAIN,
                                                          V4L2_CID_DIGITAL_GAIN,
                                                          V4L2_CID_ISO_SENSITIVITY,
                                                          V4L2_CID_WHITE_BALANCE_TEMPERATURE,
                                                          V4L2_CID_RED_BALANCE,
                                                          V4L2_CID_BLUE_BALANCE,
                                                          V4L2_CID_FOCUS_ABSOLUTE,
                                                          V4L2_CID_BRIGHTNESS,
                                                          V4L2_CID_GAMMA};

const AutomaticMode* automatic_mode(std::uint32_t id) {
  for (const AutomaticMode& mode : kAutomaticModes)
    if (mode.id == id) return &mode;
  return nullptr;
}

bool is_brightness_value(std::uint32_t id) {
  return std::find(kBrightnessValues.begin(), kBrightnessValues.end(), id) !=
         kBrightnessValues.end();
}

int transfer(const V4l2Device& device, unsigned long request, std::uint32_t id, bool is_wide,
             std::int64_t& value) {
  v4l2_ext_control one;
  std::memset(&one, 0, sizeof one);
  one.id = id;
  if (is_wide) {
    one.value64 = value;
  } else {
    one.value = static_cast<std::int32_t>(value);
  }
  v4l2_ext_controls all;
  std::memset(&all, 0, sizeof all);
  all.which = V4L2_CTRL_WHICH_CUR_VAL;
  all.count = 1;
  all.controls = &one;
  const int error = device.ioctl(request, &all);
  if (error == 0) value = is_wide ? static_cast<std::int64_t>(one.value64) : one.value;
  return error;
}

bool query(const V4l2Device& device, std::uint32_t id, v4l2_query_ext_ctrl& answer) {
  std::memset(&answer, 0, sizeof answer);
  answer.id = id;
  return device.ioctl(VIDIOC_QUERY_EXT_CTRL, &answer) == 0;
}

bool is_wide(const V4l2Device& device, std::uint32_t id) {
  v4l2_query_ext_ctrl answer;
  return query(device, id, answer) && answer.type == V4L2_CTRL_TYPE_INTEGER64;
}

std::vector<MenuItem> menu_of(const V4l2Device& device, const CameraControl& control) {
  std::vector<MenuItem> items;
  constexpr std::int64_t kMaxItems = 256;  // a driver's menu without end is a fault
  const std::int64_t first = std::max<std::int64_t>(control.low, 0);
  if (control.high < first) return items;
  const std::int64_t count = std::min(control.high - first, kMaxItems - 1) + 1;
  for (std::int64_t n = 0; n < count; ++n) {
    const std::int64_t i = first + n;
    v4l2_querymenu item;
    std::memset(&item, 0, sizeof item);
    item.id = control.id;
    item.index = static_cast<std::uint32_t>(i);
    if (device.ioctl(VIDIOC_QUERYMENU, &item) != 0) continue;  // menus may have gaps
    if (control.type == ControlType::kIntegerMenu) {
      items.push_back({i, fmt::format("{}", static_cast<std::int64_t>(item.value))});
    } else {
      const auto* name = reinterpret_cast<const char*>(item.name);
      items.push_back({i, std::string(name, strnlen(name, sizeof item.name))});
    }
  }
  return items;
}

/// Manual where the camera has it; for exposure, else the mode with only the aperture automatic.
std::optional<std::int64_t> off_value(const CameraControl& control, const AutomaticMode& mode) {
  if (control.type != ControlType::kMenu) return mode.off;
  const auto has = [&](std::int64_t value) {
    return std::any_of(control.menu.begin(), control.menu.end(),
                       [&](const MenuItem& item) { return item.value == value; });
  };
  if (has(mode.off)) return mode.off;
  if (mode.id == V4L2_CID_EXPOSURE_AUTO && has(V4L2_EXPOSURE_SHUTTER_PRIORITY))
    return V4L2_EXPOSURE_SHUTTER_PRIORITY;
  return std::nullopt;
}

}  // namespace

std::string_view to_string(ControlType type) {
  switch (type) {
    case ControlType::kInteger:
      return "integer";
    case ControlType::kBoolean:
      return "boolean";
    case ControlType::kMenu:
      return "menu";
    case ControlType::kIntegerMenu:
      return "integer menu";
    case ControlType::kButton:
      return "button";
    case ControlType::kBitmask:
      return "bitmask";
    case ControlType::kOther:
      break;
  }
  return "other";
}

ControlValue* find_control(std::vector<ControlValue>& values, std::uint32_t id) {
  for (ControlValue& value : values)
    if (value.id == id) return &value;
  return nullptr;
}

void merge_controls(std::vector<ControlValue>& values, const std::vector<ControlValue>& updates) {
  for (const ControlValue& value : updates) {
    if (ControlValue* old = find_control(values, value.id)) {
      old->value = value.value;
      continue;
    }
    const auto behind = std::find_if(values.begin(), values.end(), [&](const ControlValue& other) {
      return other.id > value.id;
    });
    values.insert(behind, value);
  }
}

std::vector<CameraControl> list_controls(const V4l2Device& device) {
  std::vector<CameraControl> controls;
  std::uint32_t last = 0;
  v4l2_query_ext_ctrl answer;
  // Drivers count upwards; one that does not would never end.
  while (query(device, last | V4L2_CTRL_FLAG_NEXT_CTRL, answer) && answer.id > last) {
    last = answer.id;
    if ((answer.flags & V4L2_CTRL_FLAG_DISABLED) != 0 || answer.type == V4L2_CTRL_TYPE_CTRL_CLASS)
      continue;
    CameraControl control;
    control.id = answer.id;
    control.name = std::string(answer.name, strnlen(answer.name, sizeof answer.name));
    control.type = type_of(answer.type);
    control.low = answer.minimum;
    control.high = answer.maximum;
    control.step = static_cast<std::int64_t>(answer.step);
    control.default_value = answer.default_value;
    control.is_read_only = (answer.flags & V4L2_CTRL_FLAG_READ_ONLY) != 0;
    control.is_inactive = (answer.flags & (V4L2_CTRL_FLAG_INACTIVE | V4L2_CTRL_FLAG_GRABBED)) != 0;
    if (control.type == ControlType::kMenu || control.type == ControlType::kIntegerMenu)
      control.menu = menu_of(device, control);
    const bool is_readable = control.type != ControlType::kOther &&
                             control.type != ControlType::kButton &&
                             (answer.flags & V4L2_CTRL_FLAG_WRITE_ONLY) == 0;
    if (is_readable && transfer(device, VIDIOC_G_EXT_CTRLS, control.id,
                                answer.type == V4L2_CTRL_TYPE_INTEGER64, control.value) != 0)
      control.type = ControlType::kOther;  // not readable now, so not restorable
    controls.push_back(std::move(control));
  }
  return controls;
}

Result<std::int64_t> read_control(const V4l2Device& device, const ControlValue& control) {
  std::int64_t value = 0;
  const int error =
      transfer(device, VIDIOC_G_EXT_CTRLS, control.id, is_wide(device, control.id), value);
  if (error != 0)
    return camera_error(en::say("'{}' cannot be read", control.name), device.node(), error);
  return value;
}

Status write_control(const V4l2Device& device, const ControlValue& control) {
  std::int64_t value = control.value;
  const int error =
      transfer(device, VIDIOC_S_EXT_CTRLS, control.id, is_wide(device, control.id), value);
  const Message doing = en::say("'{}' cannot be set to {}", control.name, control.value);
  if (error == ERANGE || error == EINVAL)
    return Error{en::at(doing, en::say("the camera refuses this value")), device.node(),
                 en::say("a value within its range; 'alltact devices --details' lists the ranges")};
  if (error == EACCES)
    return Error{en::at(doing, en::say("an automatic mode controls it")), device.node(),
                 en::say("switch that mode off first")};
  if (error != 0) return camera_error(doing, device.node(), error);
  if (value != control.value)
    return Error{
        en::at(doing, en::say("the camera uses {} instead", value)), device.node(),
        en::say("a value within its range and steps; 'alltact devices --details' lists them")};
  return {};
}

std::vector<ControlValue> settings_of(const std::vector<CameraControl>& controls) {
  std::vector<ControlValue> values;
  for (const CameraControl& control : controls)
    if (control.is_setting() && !control.is_inactive)
      values.push_back({control.id, control.name, control.value});
  return values;
}

std::vector<Message> restore_controls(const V4l2Device& device,
                                      const std::vector<ControlValue>& requested) {
  std::vector<Message> problems;
  for (const bool modes_now : {true, false}) {
    for (const ControlValue& control : requested) {
      if ((automatic_mode(control.id) != nullptr) != modes_now) continue;
      const auto now = read_control(device, control);
      if (now.ok() && *now == control.value) continue;
      if (const Status status = write_control(device, control); !status)
        problems.push_back(status.error().message());
    }
  }
  return problems;
}

std::vector<ControlValue> lock_brightness(const V4l2Device& device,
                                          std::vector<Message>& problems) {
  for (const CameraControl& control : list_controls(device)) {
    const AutomaticMode* mode = automatic_mode(control.id);
    if (mode == nullptr || !control.is_setting()) continue;
    const auto off = off_value(control, *mode);
    if (!off) {
      problems.push_back(
          en::say("'{}' cannot be switched off: brightness may drift", control.name));
    } else if (control.value != *off) {
      const Status status = write_control(device, {control.id, control.name, *off});
      if (!status) problems.push_back(status.error().message());
    }
  }
  std::vector<ControlValue> held;
  for (const ControlValue& value : settings_of(list_controls(device)))
    if (automatic_mode(value.id) != nullptr || is_brightness_value(value.id)) held.push_back(value);
  return held;
}

std::vector<CameraControl> automatic_modes_on(const std::vector<CameraControl>& controls) {
  std::vector<CameraControl> on;
  for (const CameraControl& control : controls) {
    const AutomaticMode* mode = automatic_mode(control.id);
    // Without a manual mode, the camera's best mode counts as off.
    if (mode != nullptr && control.is_setting() &&
        control.value != off_value(control, *mode).value_or(mode->off))
      on.push_back(control);
  }
  return on;
}

void watch_changes(const V4l2Device& device, const std::vector<CameraControl>& controls) {
  const auto subscribe = [&](std::uint32_t type, std::uint32_t id) {
    v4l2_event_subscription subscription;
    std::memset(&subscription, 0, sizeof subscription);
    subscription.type = type;
    subscription.id = id;
    return device.ioctl(VIDIOC_SUBSCRIBE_EVENT, &subscription) != ENOTTY;
  };
  if (!subscribe(V4L2_EVENT_SOURCE_CHANGE, 0)) return;  // cameras with one source refuse this one
  for (const CameraControl& control : controls)
    if (control.is_setting() && !subscribe(V4L2_EVENT_CTRL, control.id)) return;
}

std::optional<std::variant<ControlValue, SourceChange>> next_change(const V4l2Device& device) {
  v4l2_event event;
  std::memset(&event, 0, sizeof event);
  while (device.ioctl(VIDIOC_DQEVENT, &event) == 0) {
    if (event.type == V4L2_EVENT_SOURCE_CHANGE) return SourceChange{};
    if (event.type != V4L2_EVENT_CTRL || (event.u.ctrl.changes & V4L2_EVENT_CTRL_CH_VALUE) == 0)
      continue;
    const bool wide = event.u.ctrl.type == V4L2_CTRL_TYPE_INTEGER64;
    return ControlValue{
        event.id,
        {},
        wide ? static_cast<std::int64_t>(event.u.ctrl.value64) : std::int64_t{event.u.ctrl.value}};
  }
  return std::nullopt;
}

}  // namespace alltact
