// The finger's lamp for the window: one dimmer, set beside it.
#pragma once

#include "core/sources/hid/led_dimmer.h"
#include "widgets/background_work.h"
#include "widgets/live/hid_ports.h"

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// An object of the window's thread; the device is looked for and told beside it.
class Lamp : public QObject {
  Q_OBJECT
 public:
  explicit Lamp(HidPorts ports = {}, QObject* parent = nullptr);

  /// Which devices there are; found() holds them when changed() tells.
  void look();
  [[nodiscard]] const std::vector<FoundHid>& found() const { return found_; }

  /// From now on; the newest wins where several follow each other quickly. None: the lamp is left
  /// as it is.
  void set(const std::optional<DimmerSetting>& wanted);
  /// What somebody wants; what it came to is in setting().
  [[nodiscard]] const std::optional<DimmerSetting>& wanted() const { return wanted_; }
  /// As the device took it, rounded to its steps; nullopt while it has not.
  [[nodiscard]] const std::optional<DimmerSetting>& setting() const { return setting_; }
  /// Why it has not.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void changed();

 private:
  struct Device;
  void work();

  HidPorts ports_;
  std::vector<FoundHid> found_;
  std::optional<DimmerSetting> wanted_, setting_;
  bool is_told_ = true;  // wanted_ was told to the device
  std::optional<Error> problem_;
  std::shared_ptr<Device> device_;
  BackgroundWork looking_, setting_work_;
};

}  // namespace alltact
