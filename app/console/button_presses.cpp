#include "app/console/button_presses.h"

namespace alltact {
namespace {

/// Returns the port that is open already, and opens the device again from then on.
HidButton::Opener opener(std::unique_ptr<HidPort> port, const std::string& device) {
  auto first = std::make_shared<std::unique_ptr<HidPort>>(std::move(port));
  return [first, device]() -> Result<std::unique_ptr<HidPort>> {
    if (*first != nullptr) return std::move(*first);
    return open_hid(device);
  };
}

}  // namespace

ButtonPresses::ButtonPresses(std::unique_ptr<HidPort> port, const LearntButton& button)
    : button_(opener(std::move(port), button.device), button.pattern, [this] { ++presses_; }) {}

Result<std::unique_ptr<ButtonPresses>> ButtonPresses::listen(const LearntButton& button) {
  auto port = open_hid(button.device);
  if (!port) return port.error();
  return std::unique_ptr<ButtonPresses>(new ButtonPresses(std::move(*port), button));
}

bool ButtonPresses::taken(Console& console) {
  const Status status = button_.status();
  if (!status && !is_away_)
    console.warn("The button is not heard now. " + status.error().sentence());
  if (status && is_away_) console.warn("The button is heard again.");
  is_away_ = !status.ok();
  return presses_.exchange(0) > 0;
}

}  // namespace alltact
