// A foot pedal or any other button: the program learns it from presses, then recognises it.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/devices/hid_port.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Common bits of a device's reports while the button is held.
struct ButtonPattern {
  struct Byte {
    std::size_t at = 0;
    std::uint8_t mask = 0;   ///< the bits that change
    std::uint8_t value = 0;  ///< these bits while pressed
    bool operator==(const Byte&) const = default;
  };
  std::size_t report_bytes = 0;
  std::vector<Byte> bytes;

  [[nodiscard]] bool is_pressed(const std::vector<std::uint8_t>& report) const;
  /// "8 2:ff=05,3:01=01": bytes of a report, then position:mask=value of each relevant byte.
  [[nodiscard]] std::string text() const;
  /// Error: not of that form.
  static Result<ButtonPattern> parse(const std::string& text);
  bool operator==(const ButtonPattern&) const = default;
};

/// A button of one device, as settings store it and commands take it: "0c45:7403/0 4 2:05=05".
struct LearntButton {
  std::string device;  ///< HidIdentity::stable_name(), or another name that open_hid() takes
  ButtonPattern pattern;

  [[nodiscard]] std::string text() const { return device + " " + pattern.text(); }
  /// Error: not of that form.
  static Result<LearntButton> parse(const std::string& text);
};

/// Learns a button from reports. Feed it the reports at rest (possibly none, for a device that
/// reports only changes), call begin(), then feed it two presses.
class ButtonLearner {
 public:
  void begin() { is_begun_ = true; }
  void feed(const std::vector<std::uint8_t>& report);
  /// The pattern, after two presses that agree.
  [[nodiscard]] const std::optional<ButtonPattern>& pattern() const { return pattern_; }
  [[nodiscard]] int presses() const { return presses_; }

 private:
  void feed_rest(const std::vector<std::uint8_t>& report);
  void finish_press(const std::vector<std::uint8_t>& released);

  bool is_begun_ = false;
  std::vector<std::uint8_t> rest_, noise_, pressed_;
  std::optional<ButtonPattern> candidate_, pattern_;
  int presses_ = 0;
};

/// Listens to all ports for `timeout_ms`. Returns the index of the port whose button was pressed
/// twice, with its pattern. Reports "press it now" to the job once the devices' rest is known.
/// Errors: nothing was pressed, or the job was stopped.
[[nodiscard]] Result<std::pair<std::size_t, ButtonPattern>> learn_button(
    const std::vector<HidPort*>& ports, int timeout_ms, const Job& job);

/// Calls `on_press` once for each press, from a thread of its own. Waits for an unplugged device to
/// come back.
class HidButton {
 public:
  using Opener = std::function<Result<std::unique_ptr<HidPort>>()>;
  HidButton(Opener open, ButtonPattern pattern, std::function<void()> on_press);
  ~HidButton() = default;  ///< waits for a running `on_press`
  HidButton(const HidButton&) = delete;
  HidButton& operator=(const HidButton&) = delete;

  /// Error: why presses are not received now. Any thread.
  [[nodiscard]] Status status() const;

 private:
  void run(const std::stop_token& stop);
  void listen(HidPort& port, const std::stop_token& stop);
  void set_status(Status status);

  Opener open_;
  ButtonPattern pattern_;
  std::function<void()> on_press_;
  mutable std::mutex mutex_;
  Status status_;
  Worker worker_;  // last: it ends first
};

}  // namespace alltact
