// The camera's settings: added to every frame, changed, and locked.
#include "core/sources/frame_settings.h"
#include "core/sources/v4l2/v4l2_camera.h"

namespace alltact {

/// Known settings, without a request to the camera for each frame.
std::shared_ptr<const std::string> V4l2Camera::controls_now() {
  std::string text;
  add_setting(text, "Camera", access_.identity);
  if (!access_.serial.empty()) add_setting(text, "Serial number", access_.serial);
  add_setting(text, "Format", format_.text().english());
  {
    const std::lock_guard lock(device_mutex_);
    for (const ControlValue& control : restore_values_)
      add_setting(text, control.name, fmt::format("{}", control.value));
  }
  if (frame_controls_ == nullptr || *frame_controls_ != text)
    frame_controls_ = std::make_shared<const std::string>(std::move(text));
  return frame_controls_;
}

CameraSettings V4l2Camera::settings() const {
  const std::lock_guard lock(device_mutex_);
  return {access_.identity,
          format_,
          device_ == nullptr ? restore_values_ : settings_of(list_controls(*device_))};
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
  merge_controls(restore_values_, {control});
  if (ControlValue* held = find_control(held_, control.id)) held->value = control.value;
  return {};
}

Status V4l2Camera::lock() {
  const std::lock_guard lock(device_mutex_);
  if (device_ == nullptr) return unplugged();
  std::vector<Message> problems;
  held_ = lock_brightness(*device_, problems);
  merge_controls(restore_values_, held_);
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
  if (is_other_source) renegotiate();
}

void V4l2Camera::check_next_held() {
  next_check_ = std::chrono::steady_clock::now() + kCheckInterval;
  const auto held = locked();
  if (held.empty()) return;
  const ControlValue& control = held[next_held_++ % held.size()];
  const auto now = read_control(*device_, control);
  if (now.ok()) on_change({control.id, {}, *now});  // a failed read shows as a fault of the stream
}

void V4l2Camera::on_change(const ControlValue& change) {
  const std::lock_guard lock(device_mutex_);
  ControlValue* held = find_control(held_, change.id);
  ControlValue* to_restore = find_control(restore_values_, change.id);
  if (held == nullptr) {
    if (to_restore != nullptr) to_restore->value = change.value;
    return;
  }
  if (change.value == held->value) return;
  const Status status = write_control(*device_, *held);
  if (status.ok()) {
    const std::lock_guard status_lock(status_mutex_);
    ++status_.counts.restored;
  }
  const Message changed = en::say(
      "'{}' was changed from {} to {} by something else", held->name, held->value, change.value);
  remark(
      en::clauses({changed, status.ok() ? en::say("it was put back") : status.error().message()}));
}

}  // namespace alltact
