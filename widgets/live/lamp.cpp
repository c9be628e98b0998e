#include "widgets/live/lamp.h"

namespace alltact {

/// Used by one piece of work after the other.
struct Lamp::Device {
  std::optional<LedDimmer> dimmer;
};

Lamp::Lamp(HidPorts ports, QObject* parent)
    : QObject(parent), ports_(std::move(ports)), device_(std::make_shared<Device>()) {
  connect(&setting_work_, &BackgroundWork::finished, this, &Lamp::work);
}

void Lamp::look() {
  looking_.start([this, list = ports_.list](const Job&) {
    return std::function<void()>([this, found = list()] {
      found_ = found;
      Q_EMIT changed();
    });
  });
}

void Lamp::set(const std::optional<DimmerSetting>& wanted) {
  wanted_ = wanted;
  is_told_ = !wanted;
  problem_.reset();
  if (!wanted) setting_.reset();
  work();
  Q_EMIT changed();
}

void Lamp::work() {
  if (is_told_ || setting_work_.is_running()) return;
  is_told_ = true;
  setting_work_.start([this, wanted = *wanted_, device = device_, open = ports_.open](const Job&) {
    const auto told = [&]() -> Result<DimmerSetting> {
      auto& dimmer = device->dimmer;
      if (!dimmer || dimmer->setting().device != wanted.device ||
          dimmer->setting().control != wanted.control) {
        dimmer.reset();
        auto port = open(wanted.device);
        if (!port) return port.error();
        auto made = LedDimmer::create(std::move(*port), wanted.device, wanted.control);
        if (!made) return made.error();
        dimmer.emplace(std::move(*made));
      }
      if (const Status set = dimmer->set(wanted.level); !set) {
        dimmer.reset();  // plugged in again it is another one
        return set.error();
      }
      return dimmer->setting();
    }();
    return std::function<void()>([this, told] {
      if (!wanted_) return;
      setting_ = told ? std::optional(*told) : std::nullopt;
      problem_ = told ? std::nullopt : std::optional(told.error());
      Q_EMIT changed();
    });
  });
}

}  // namespace alltact
