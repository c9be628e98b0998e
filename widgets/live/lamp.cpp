#include "widgets/live/lamp.h"

namespace alltact {

/// Used by one background task after the other.
struct Lamp::Device {
  std::optional<LedDimmer> dimmer;
};

Lamp::Lamp(HidPorts ports, QObject* parent)
    : QObject(parent), ports_(std::move(ports)), device_(std::make_shared<Device>()) {
  connect(&setting_work_, &BackgroundWork::finished, this, &Lamp::send);
}

void Lamp::find_devices() {
  finding_.start([this, list = ports_.list](const Job&) {
    return std::function<void()>([this, found = list()] {
      found_ = found;
      Q_EMIT changed();
    });
  });
}

void Lamp::set(const std::optional<DimmerSetting>& requested) {
  requested_ = requested;
  is_sent_ = !requested;
  problem_.reset();
  if (!requested) setting_.reset();
  send();
  Q_EMIT changed();
}

void Lamp::send() {
  if (is_sent_ || setting_work_.is_running()) return;
  is_sent_ = true;
  setting_work_.start(
      [this, requested = *requested_, device = device_, open = ports_.open](const Job&) {
        const auto result = [&]() -> Result<DimmerSetting> {
          auto& dimmer = device->dimmer;
          if (!dimmer || dimmer->setting().device != requested.device ||
              dimmer->setting().control != requested.control) {
            dimmer.reset();
            auto port = open(requested.device);
            if (!port) return port.error();
            auto made = LedDimmer::create(std::move(*port), requested.device, requested.control);
            if (!made) return made.error();
            dimmer.emplace(std::move(*made));
          }
          if (const Status set = dimmer->set(requested.level); !set) {
            dimmer.reset();  // plugged in again it is another device
            return set.error();
          }
          return dimmer->setting();
        }();
        return std::function<void()>([this, result] {
          if (!requested_) return;
          setting_ = result ? std::optional(*result) : std::nullopt;
          problem_ = result ? std::nullopt : std::optional(result.error());
          Q_EMIT changed();
        });
      });
}

}  // namespace alltact
