// What the camera is set to: told with every frame, changed, and held still.
#include "core/sources/frame_settings.h"
#include "core/sources/v4l2/v4l2_camera.h"

namespace alltact {

/// As far as they are known without asking the camera for each frame.
std::shared_ptr<const std::string> V4l2Camera::controls_now() {
  std::string text;
  add_setting(text, "Camera", place_.identity);
  if (!place_.serial.empty()) add_setting(text, "Serial number", place_.serial);
  add_setting(text, "Format", format_.text().english());
  {
    const std::lock_guard lock(device_mutex_);
    for (const ControlValue& control : wanted_)
      add_setting(text, control.name, fmt::format("{}", control.value));
  }
  if (told_controls_ == nullptr || *told_controls_ != text)
    told_controls_ = std::make_shared<const std::string>(std::move(text));
  return told_controls_;
}

CameraSettings V4l2Camera::settings() const {
  const std::lock_guard lock(device_mutex_);
  return {place_.identity,
          format_,
          device_ == nullptr ? wanted_ : settings_of(list_controls(*device_))};
}

Result<std::vector<CameraControl>> V4l2Camera::controls() const {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  return list_controls(*device_);
}

Status V4l2Camera::set_control(const ControlValue& control) {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  if (const Status status = write_control(*device_, control); !status) return status;
  merge_controls(wanted_, {control});
  if (ControlValue* held = find_control(held_, control.id)) held->value = control.value;
  return {};
}

Status V4l2Camera::lock() {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  std::vector<Message> problems;
  held_ = lock_brightness(*device_, problems);
  merge_controls(wanted_, held_);
  for (const Message& problem : problems) remark(problem);
  return {};
}

void V4l2Camera::unlock() {
  const std::lock_guard lock(device_mutex_);
  held_.clear();
}

std::vector<ControlValue> V4l2Camera::locked() const {
  const std::lock_guard lock(device_mutex_);
  return held_;
}

void V4l2Camera::follow_changes() {
  bool is_other_source = false;
  while (const auto change = next_change(*device_)) {
    if (const auto* control = std::get_if<ControlValue>(&*change)) {
      on_change(*control);
    } else {
      is_other_source = true;
    }
  }
  if (is_other_source) agree_anew();
}

void V4l2Camera::check_next_held() {
  next_check_ = std::chrono::steady_clock::now() + kBetweenChecks;
  const auto held = locked();
  if (held.empty()) return;
  const ControlValue& control = held[next_held_++ % held.size()];
  const auto now = read_control(*device_, control);
  if (now.ok()) on_change({control.id, {}, *now});  // a failed read shows as a fault of the stream
}

void V4l2Camera::on_change(const ControlValue& change) {
  const std::lock_guard lock(device_mutex_);
  ControlValue* held = find_control(held_, change.id);
  ControlValue* wanted = find_control(wanted_, change.id);
  if (held == nullptr) {
    if (wanted != nullptr) wanted->value = change.value;
    return;
  }
  if (change.value == held->value) return;
  const Status status = write_control(*device_, *held);
  if (status.ok()) {
    const std::lock_guard status_lock(status_mutex_);
    ++status_.counts.put_back;
  }
  const Message changed = en::say(
      "'{}' was changed from {} to {} by something else", held->name, held->value, change.value);
  remark(
      en::clauses({changed, status.ok() ? en::say("it was put back") : status.error().message()}));
}

}  // namespace alltact
