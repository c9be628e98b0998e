// Lists the connected cameras and reports each change.
#pragma once

#include "core/base/worker.h"
#include "core/devices/camera_list.h"
#include "core/devices/hid_button.h"
#include "core/devices/hid_port.h"
#include "core/devices/led_dimmer.h"
#include "widgets/background_work.h"

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Lists on a background thread, because a camera may answer slowly.
class CameraFinder : public QObject {
  Q_OBJECT
 public:
  using Lister = std::function<std::vector<FoundCamera>()>;

  explicit CameraFinder(Lister lister = {}, QObject* parent = nullptr);
  ~CameraFinder() override;
  [[nodiscard]] const std::vector<FoundCamera>& cameras() const { return cameras_; }

 Q_SIGNALS:
  void cameras_changed();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  Worker worker_;
  std::vector<FoundCamera> cameras_;
};

// Names of cameras in lists.

/// The maker's name; where another camera has the same, with its USB port.
[[nodiscard]] QString camera_label(const FoundCamera& camera,
                                   const std::vector<FoundCamera>& cameras);

// Functions behind a pedal or a lamp, replaceable in tests.

/// Called on background threads.
struct HidPorts {
  std::function<std::vector<FoundHid>()> list = &list_hids;
  std::function<Result<std::unique_ptr<HidPort>>(const std::string& requested)> open = &open_hid;
};

// A foot pedal or button: learnt once, then reported with each press.

/// Belongs to the window's thread; finds, learns and reads devices on background threads.
class Pedal : public QObject {
  Q_OBJECT
 public:
  explicit Pedal(HidPorts ports = {}, QObject* parent = nullptr);
  ~Pedal() override;

  /// Listens to it from now on, also after it was unplugged and plugged in again; none: to none.
  void listen(const std::optional<LearntButton>& button);
  [[nodiscard]] const std::optional<LearntButton>& button() const { return button_; }
  /// Why presses are not heard; none while it works or no pedal is chosen.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  /// Waits for a pedal that is pressed twice and listens to it; without one, to the former pedal.
  /// Does nothing while it learns.
  void learn();
  void stop_learning();
  [[nodiscard]] bool is_learning() const { return learning_.is_running(); }
  /// Next instruction, or why nothing was learnt; may be empty.
  [[nodiscard]] const QString& learning_text() const { return learning_text_; }

 Q_SIGNALS:
  void pressed();
  /// button(), problem(), is_learning() or learning_text() changed.
  void changed();

 private:
  struct Shared;
  void check_status();
  void end_learning(const Result<LearntButton>& learnt, const std::optional<LearntButton>& before);

  HidPorts ports_;
  std::optional<LearntButton> button_;
  std::optional<Error> problem_;
  std::shared_ptr<Shared> shared_;
  QTimer timer_;
  BackgroundWork learning_;
  QString learning_text_;
};

// The finger's lamp: one dimmer, set on a background thread.

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
  void send();

  HidPorts ports_;
  std::vector<FoundHid> found_;
  std::optional<DimmerSetting> requested_, setting_;
  bool is_sent_ = true;  // requested_ was sent to the device
  std::optional<Error> problem_;
  /// Open dimmer, used by one background task after the other.
  std::shared_ptr<std::optional<LedDimmer>> dimmer_ = std::make_shared<std::optional<LedDimmer>>();
  BackgroundWork finding_, setting_work_;
};

}  // namespace alltact
