// The finger's lamp: one dimmer, set on a background thread.
#pragma once

#include "core/sources/hid/led_dimmer.h"
#include "widgets/background_work.h"
#include "widgets/live/hid_ports.h"

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// Belongs to the window's thread; finds and sets the device on background threads.
class Lamp : public QObject {
  Q_OBJECT
 public:
  explicit Lamp(HidPorts ports = {}, QObject* parent = nullptr);

  /// Lists the devices; found() holds them when changed() is emitted.
  void find_devices();
  [[nodiscard]] const std::vector<FoundHid>& found() const { return found_; }

  /// Sets the lamp; of several quick calls the newest wins. None: the lamp is left as it is.
  void set(const std::optional<DimmerSetting>& requested);
  /// Requested setting; the setting of the device is in setting().
  [[nodiscard]] const std::optional<DimmerSetting>& requested() const { return requested_; }
  /// Setting that the device accepted, rounded to its steps; nullopt: not yet.
  [[nodiscard]] const std::optional<DimmerSetting>& setting() const { return setting_; }
  /// Why the device did not accept it.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void changed();

 private:
  struct Device;
  void send();

  HidPorts ports_;
  std::vector<FoundHid> found_;
  std::optional<DimmerSetting> requested_, setting_;
  bool is_sent_ = true;  // requested_ was sent to the device
  std::optional<Error> problem_;
  std::shared_ptr<Device> device_;
  BackgroundWork finding_, setting_work_;
};

}  // namespace alltact
