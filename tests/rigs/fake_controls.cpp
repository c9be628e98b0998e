#include "tests/rigs/fake_controls.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace alltact::test {

FakeControls::FakeControls() {
  const auto kClass = V4L2_CTRL_TYPE_CTRL_CLASS;
  const auto kInteger = V4L2_CTRL_TYPE_INTEGER;
  const auto kBoolean = V4L2_CTRL_TYPE_BOOLEAN;
  const auto kMenu = V4L2_CTRL_TYPE_MENU;
  controls_ = {
      {V4L2_CID_USER_CLASS, "User Controls", kClass, 0, 0, 0, 0},
      {V4L2_CID_BRIGHTNESS, "Brightness", kInteger, 0, 255, 1, 128},
      {V4L2_CID_AUTO_WHITE_BALANCE, "White Balance, Automatic", kBoolean, 0, 1, 1, 1},
      {V4L2_CID_GAIN, "Gain", kInteger, 0, 100, 1, 10},
      {V4L2_CID_WHITE_BALANCE_TEMPERATURE, "White Balance Temperature", kInteger, 2800, 6500, 10,
       4600, V4L2_CID_AUTO_WHITE_BALANCE, 0},
      {V4L2_CID_CAMERA_CLASS, "Camera Controls", kClass, 0, 0, 0, 0},
      {V4L2_CID_EXPOSURE_AUTO,
       "Auto Exposure",
       kMenu,
       0,
       3,
       1,
       V4L2_EXPOSURE_APERTURE_PRIORITY,
       0,
       0,
       {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}}},
      {V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure Time, Absolute", kInteger, 3, 2047, 1, 250,
       V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL},
      {V4L2_CID_FOCUS_ABSOLUTE, "Focus, Absolute", kInteger, 0, 250, 5, 0, V4L2_CID_FOCUS_AUTO, 0},
      {V4L2_CID_FOCUS_AUTO, "Focus, Automatic Continuous", kBoolean, 0, 1, 1, 1},
  };
  std::sort(controls_.begin(), controls_.end(),
            [](const Control& a, const Control& b) { return a.id < b.id; });
  reset();
}

void FakeControls::reset() {
  for (Control& control : controls_) control.value = control.initial;
}

const FakeControls::Control* FakeControls::control(std::uint32_t id) const {
  for (const Control& control : controls_)
    if (control.id == id) return &control;
  return nullptr;
}

FakeControls::Control* FakeControls::control(std::uint32_t id) {
  return const_cast<Control*>(static_cast<const FakeControls*>(this)->control(id));
}

const FakeControls::Control* FakeControls::after(std::uint32_t id) const {
  for (const Control& control : controls_)
    if (control.id > id) return &control;
  return nullptr;
}

std::uint32_t FakeControls::flags_of(const Control& control) const {
  if (control.type == V4L2_CTRL_TYPE_CTRL_CLASS)
    return V4L2_CTRL_FLAG_READ_ONLY | V4L2_CTRL_FLAG_WRITE_ONLY;
  const bool is_inactive =
      control.automatic != 0 && value(control.automatic) != control.automatic_free;
  return is_inactive ? V4L2_CTRL_FLAG_INACTIVE : 0;
}

int FakeControls::query(v4l2_query_ext_ctrl& query) const {
  const std::uint32_t next = query.id & (V4L2_CTRL_FLAG_NEXT_CTRL | V4L2_CTRL_FLAG_NEXT_COMPOUND);
  const std::uint32_t id = query.id & ~next;
  if (next == V4L2_CTRL_FLAG_NEXT_COMPOUND) return EINVAL;
  const Control* found = next != 0 ? after(id) : control(id);
  if (found == nullptr) return EINVAL;
  std::memset(&query, 0, sizeof query);
  query.id = found->id;
  query.type = found->type;
  std::strncpy(query.name, found->name, sizeof query.name - 1);
  query.minimum = found->low;
  query.maximum = found->high;
  query.step = static_cast<std::uint64_t>(found->step);
  query.default_value = found->initial;
  query.flags = flags_of(*found);
  query.elem_size = found->type == V4L2_CTRL_TYPE_CTRL_CLASS ? 0 : 4;
  query.elems = found->type == V4L2_CTRL_TYPE_CTRL_CLASS ? 0 : 1;
  return 0;
}

int FakeControls::query(v4l2_queryctrl& old) const {
  v4l2_query_ext_ctrl answer;
  std::memset(&answer, 0, sizeof answer);
  answer.id = old.id;
  if (const int error = query(answer); error != 0) return error;
  std::memset(&old, 0, sizeof old);
  old.id = answer.id;
  old.type = answer.type;
  std::memcpy(old.name, answer.name, sizeof old.name);
  old.minimum = static_cast<std::int32_t>(answer.minimum);
  old.maximum = static_cast<std::int32_t>(answer.maximum);
  old.step = static_cast<std::int32_t>(answer.step);
  old.default_value = static_cast<std::int32_t>(answer.default_value);
  old.flags = answer.flags;
  return 0;
}

int FakeControls::query(v4l2_querymenu& query) const {
  const Control* found = control(query.id);
  if (found == nullptr || found->type != V4L2_CTRL_TYPE_MENU) return EINVAL;
  const auto item = found->menu.find(query.index);
  if (item == found->menu.end()) return EINVAL;
  const std::uint32_t id = query.id, index = query.index;
  std::memset(&query, 0, sizeof query);
  query.id = id;
  query.index = index;
  std::strncpy(reinterpret_cast<char*>(query.name), item->second, sizeof query.name - 1);
  return 0;
}

v4l2_event FakeControls::event(std::uint32_t id, std::uint32_t changes) const {
  const Control& control = *this->control(id);
  v4l2_event event;
  std::memset(&event, 0, sizeof event);
  event.type = V4L2_EVENT_CTRL;
  event.id = id;
  event.u.ctrl.changes = changes;
  event.u.ctrl.type = control.type;
  if (control.type != V4L2_CTRL_TYPE_CTRL_CLASS) event.u.ctrl.value = control.value;
  event.u.ctrl.flags = flags_of(control);
  event.u.ctrl.minimum = control.low;
  event.u.ctrl.maximum = control.high;
  event.u.ctrl.step = control.step;
  event.u.ctrl.default_value = control.initial;
  return event;
}

int FakeControls::check(const v4l2_ext_controls& all, std::uint32_t& wrong) const {
  wrong = 0;
  if (all.which == V4L2_CTRL_WHICH_REQUEST_VAL) return EINVAL;
  for (; wrong < all.count; ++wrong) {
    const std::uint32_t id = all.controls[wrong].id;
    const Control* found = control(id);
    if (found == nullptr) return EINVAL;
    const bool is_of_class = all.which == V4L2_CTRL_WHICH_CUR_VAL ||
                             all.which == V4L2_CTRL_WHICH_DEF_VAL ||
                             all.which == V4L2_CTRL_ID2WHICH(id);
    if (!is_of_class) return EINVAL;
    if (found->type == V4L2_CTRL_TYPE_CTRL_CLASS) return EACCES;
  }
  return 0;
}

int FakeControls::get(v4l2_ext_controls& all) const {
  std::uint32_t wrong = 0;
  if (const int error = check(all, wrong); error != 0) {
    all.error_idx = all.count;  // nothing was read
    return error;
  }
  for (std::uint32_t i = 0; i < all.count; ++i) {
    const Control& from = *control(all.controls[i].id);
    all.controls[i].value = all.which == V4L2_CTRL_WHICH_DEF_VAL ? from.initial : from.value;
  }
  return 0;
}

int FakeControls::set(v4l2_ext_controls& all, bool is_trial, std::vector<std::uint32_t>& changed) {
  std::uint32_t wrong = 0;
  if (all.which == V4L2_CTRL_WHICH_DEF_VAL) return EINVAL;
  int error = check(all, wrong);
  for (std::uint32_t i = 0; error == 0 && i < all.count; ++i) {
    const Control& to = *control(all.controls[i].id);
    const auto value = static_cast<std::uint32_t>(all.controls[i].value);
    if (to.type == V4L2_CTRL_TYPE_MENU && value > static_cast<std::uint32_t>(to.high))
      error = ERANGE, wrong = i;
    else if (to.type == V4L2_CTRL_TYPE_MENU && !to.menu.contains(value))
      error = EINVAL, wrong = i;
    else if ((flags_of(to) & V4L2_CTRL_FLAG_INACTIVE) != 0 && !is_trial)
      error = EACCES, wrong = i;
  }
  if (error != 0) {
    all.error_idx = is_trial ? wrong : all.count;
    return error;
  }
  for (std::uint32_t i = 0; i < all.count; ++i) {
    Control& to = *control(all.controls[i].id);
    std::int32_t value = all.controls[i].value;
    value = std::clamp(value, to.low, to.high);
    value = to.low + (value - to.low + to.step / 2) / to.step * to.step;
    all.controls[i].value = value;
    if (is_trial || value == to.value) continue;
    to.value = value;
    changed.push_back(to.id);
  }
  return 0;
}

}  // namespace alltact::test
