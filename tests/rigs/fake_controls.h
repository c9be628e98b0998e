// The controls of the fake camera: those of a common USB camera, with automatic modes that take
// other controls in hand.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <linux/videodev2.h>

namespace alltact::test {

class FakeControls {
 public:
  FakeControls();

  /// As after plugging in.
  void reset();
  [[nodiscard]] std::int32_t value(std::uint32_t id) const { return control(id)->value; }
  [[nodiscard]] bool has(std::uint32_t id) const { return control(id) != nullptr; }
  /// Sets without any check, as the camera's own electronics would.
  void force(std::uint32_t id, std::int32_t value) { control(id)->value = value; }
  [[nodiscard]] v4l2_event event(std::uint32_t id, std::uint32_t changes) const;

  /// Each returns 0 or an error number. `changed` gets the controls whose value changed.
  int query(v4l2_query_ext_ctrl& query) const;
  int query(v4l2_queryctrl& query) const;
  int query(v4l2_querymenu& query) const;
  int get(v4l2_ext_controls& all) const;
  int set(v4l2_ext_controls& all, bool is_trial, std::vector<std::uint32_t>& changed);

 private:
  struct Control {
    std::uint32_t id;
    const char* name;
    std::uint32_t type;
    std::int32_t low, high, step, initial;
    std::uint32_t automatic = 0;      // the control that takes this one in hand...
    std::int32_t automatic_free = 0;  // ...unless it has this value
    std::map<std::uint32_t, const char*> menu = {};
    std::int32_t value = 0;
  };
  [[nodiscard]] const Control* control(std::uint32_t id) const;
  [[nodiscard]] Control* control(std::uint32_t id);
  [[nodiscard]] const Control* after(std::uint32_t id) const;
  [[nodiscard]] std::uint32_t flags_of(const Control& control) const;
  int check(const v4l2_ext_controls& all, std::uint32_t& wrong) const;

  std::vector<Control> controls_;
};

}  // namespace alltact::test
