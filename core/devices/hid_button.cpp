#include "core/devices/hid_button.h"

#include "core/base/guarded.h"
#include "core/base/message.h"

#include <charconv>
#include <chrono>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;
using Report = std::vector<std::uint8_t>;

constexpr auto kRest = std::chrono::milliseconds(500);  // observation before "press it now"
constexpr int kSlice_ms = 20;
constexpr auto kReopenInterval = std::chrono::milliseconds(300);

/// The bits in which two reports of one size differ, without those that change at rest too.
ButtonPattern difference(const Report& rest, const Report& pressed, const Report& noise) {
  ButtonPattern pattern{pressed.size(), {}};
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    const std::uint8_t quiet = i < noise.size() ? static_cast<std::uint8_t>(~noise[i]) : 0xFF;
    const auto mask = static_cast<std::uint8_t>((rest[i] ^ pressed[i]) & quiet);
    if (mask != 0) pattern.bytes.push_back({i, mask, static_cast<std::uint8_t>(pressed[i] & mask)});
  }
  return pattern;
}

/// The common bits of two presses.
ButtonPattern common(const ButtonPattern& a, const ButtonPattern& b) {
  ButtonPattern both{a.report_bytes, {}};
  for (const auto& x : a.bytes)
    for (const auto& y : b.bytes) {
      const auto mask = static_cast<std::uint8_t>(x.mask & y.mask & ~(x.value ^ y.value));
      if (x.at == y.at && mask != 0)
        both.bytes.push_back({x.at, mask, static_cast<std::uint8_t>(x.value & mask)});
    }
  return both;
}

/// Reads a number and the character behind it (0: the end, or a comma, which stays).
template <class T>
bool take(std::string_view& text, T& number, int base, char behind) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (status != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (behind == 0) return text.empty() || text.front() == ',';
  if (text.empty() || text.front() != behind) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

bool ButtonPattern::is_pressed(const Report& report) const {
  return report.size() == report_bytes && !bytes.empty() &&
         std::all_of(bytes.begin(), bytes.end(),
                     [&](const Byte& byte) { return (report[byte.at] & byte.mask) == byte.value; });
}

std::string ButtonPattern::text() const {
  std::string text = fmt::format("{} ", report_bytes);
  for (const Byte& byte : bytes)
    text += fmt::format("{}{}:{:02x}={:02x}", text.back() == ' ' ? "" : ",", byte.at, byte.mask,
                        byte.value);
  return text;
}

Result<ButtonPattern> ButtonPattern::parse(const std::string& text) {
  const Error wrong{en::say("'{}' does not describe a button", printable(text)), "",
                    en::say("learn the button again")};
  std::string_view rest = text;
  ButtonPattern pattern;
  if (!take(rest, pattern.report_bytes, 10, ' ')) return wrong;
  while (true) {
    Byte byte;
    if (!take(rest, byte.at, 10, ':') || !take(rest, byte.mask, 16, '=') ||
        !take(rest, byte.value, 16, 0))
      return wrong;
    if (byte.at >= pattern.report_bytes || byte.mask == 0 || (byte.value & ~byte.mask) != 0)
      return wrong;
    pattern.bytes.push_back(byte);
    if (rest.empty()) return pattern;
    rest.remove_prefix(1);
  }
}

Result<LearntButton> LearntButton::parse(const std::string& text) {
  // A serial number may hold blanks; the pattern's two words are the last.
  const std::size_t last = text.rfind(' ');
  const std::size_t before =
      last == std::string::npos || last == 0 ? std::string::npos : text.rfind(' ', last - 1);
  if (before == std::string::npos || before == 0)
    return Error{en::say("'{}' does not name a device and its button", printable(text)), "",
                 en::say("'alltact devices --learn-button', which shows what to write here")};
  const auto pattern = ButtonPattern::parse(text.substr(before + 1));
  if (!pattern) return pattern.error();
  return LearntButton{text.substr(0, before), *pattern};
}

void ButtonLearner::feed(const Report& report) {
  if (report.empty() || pattern_) return;
  if (!is_begun_) return feed_rest(report);
  if (!rest_.empty() && report.size() != rest_.size()) return;  // another kind of report
  if (pressed_.empty()) {
    const bool is_rest = !rest_.empty() && difference(rest_, report, noise_).bytes.empty();
    if (!is_rest) pressed_ = report;
  } else if (rest_.empty()) {
    // Never seen at rest: the first differing report is the release.
    if (report.size() == pressed_.size() && report != pressed_) finish_press(report);
  } else if (difference(rest_, report, noise_).bytes.empty()) {
    finish_press(report);
  }
}

void ButtonLearner::feed_rest(const Report& report) {
  if (rest_.size() != report.size()) {
    rest_ = report;
    noise_.assign(report.size(), 0);
  }
  for (std::size_t i = 0; i < report.size(); ++i)
    noise_[i] = static_cast<std::uint8_t>(noise_[i] | (rest_[i] ^ report[i]));
}

void ButtonLearner::finish_press(const Report& released) {
  const ButtonPattern now = difference(released, pressed_, noise_);
  if (rest_.empty()) rest_ = released;
  pressed_.clear();
  ++presses_;
  if (candidate_) {
    const ButtonPattern both = common(*candidate_, now);
    if (!both.bytes.empty()) {
      pattern_ = both;
      return;
    }
  }
  candidate_ = now;
}

Result<std::pair<std::size_t, ButtonPattern>> learn_button(const std::vector<HidPort*>& ports,
                                                           int timeout_ms, const Job& job) {
  std::vector<ButtonLearner> learners(ports.size());
  std::vector<bool> is_alive(ports.size(), true);
  const auto begin = Clock::now();
  const auto end = begin + kRest + std::chrono::milliseconds(timeout_ms);
  bool is_begun = false;
  while (Clock::now() < end && !ports.empty()) {
    if (job.stop_requested()) return Error{en::say("learning the button was stopped"), "", ""};
    if (!is_begun && Clock::now() >= begin + kRest) {
      is_begun = true;
      for (ButtonLearner& learner : learners) learner.begin();
      job.report(0.0, en::say("press it now, twice"));
    }
    for (std::size_t i = 0; i < ports.size(); ++i) {
      if (!is_alive[i]) {
        std::this_thread::sleep_for(std::chrono::milliseconds(kSlice_ms));
        continue;
      }
      const auto report = ports[i]->read(kSlice_ms);
      is_alive[i] = report.ok();
      if (report.ok()) learners[i].feed(*report);
      if (learners[i].pattern()) return std::pair(i, *learners[i].pattern());
      if (learners[i].presses() == 1) job.report(0.5, en::say("press it once more"));
    }
  }
  return Error{en::say("no button was pressed and released twice"), "",
               en::say("another device; a pedal that only clicks must be set to send a key")};
}

HidButton::HidButton(Opener open, ButtonPattern pattern, std::function<void()> on_press)
    : open_(std::move(open)),
      pattern_(std::move(pattern)),
      on_press_(std::move(on_press)),
      worker_([this](const std::stop_token& stop) { run(stop); }) {}

Status HidButton::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void HidButton::set_status(Status status) {
  const std::lock_guard lock(mutex_);
  status_ = std::move(status);
}

void HidButton::run(const std::stop_token& stop) {
  std::unique_ptr<HidPort> port;  // open until the next attempt, so that its node is not reused
  do {
    port.reset();
    const Status ran = guarded([&] {
      auto opened = open_();
      set_status(opened ? Status() : Status(opened.error()));
      if (!opened) return;
      port = std::move(*opened);
      listen(*port, stop);
    });
    if (!ran) set_status(ran);
  } while (!is_stopped_within(stop, kReopenInterval));
}

void HidButton::listen(HidPort& port, const std::stop_token& stop) {
  bool was_pressed = false;
  while (!stop.stop_requested()) {
    const auto report = port.read(100);
    if (!report.ok()) return set_status(report.error());
    if (report->size() != pattern_.report_bytes) continue;  // timeout, or another kind
    const bool is_pressed = pattern_.is_pressed(*report);
    if (is_pressed && !was_pressed) on_press_();
    was_pressed = is_pressed;
  }
}

}  // namespace alltact
