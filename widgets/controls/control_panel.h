// A camera's controls, built from the list that the camera reports.
#pragma once

#include "core/devices/camera_controls.h"
#include "widgets/controls/devices.h"
#include "widgets/controls/number_field.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QString>
#include <QWidget>
#include <map>
#include <vector>

namespace alltact {

/// The controls that decide over brightness and sharpness come first. A locked panel shows all and
/// changes none.
class ControlPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// May be called at every poll of the camera; a control in use is not changed.
  void set_controls(const std::vector<CameraControl>& controls, bool is_locked);

 Q_SIGNALS:
  /// By the user. `before`: its value until now.
  void control_changed(quint32 id, qint64 before, qint64 value);
  void lock_changed(bool is_locked);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  class Row;
  void rebuild();
  void refresh();

  std::vector<CameraControl> controls_;
  bool is_locked_ = true;
  QCheckBox* lock_;
  QLabel* reason_;
  QLabel* empty_;
  QWidget* list_;
  std::map<std::uint32_t, Row*> rows_;
};

// Names of camera controls in the window's language.

/// The driver's own name for a control that is not one of V4L2's standard ones.
[[nodiscard]] QString control_name(const CameraControl& control);

// The lamp's brightness in the window: which dimmer, and how bright.

class LampPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// Shows the state of `lamp`; listeners of setting_requested make the changes.
  explicit LampPanel(Lamp& lamp, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// None: the lamp is left as it is.
  void setting_requested(const std::optional<alltact::DimmerSetting>& setting);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void name_parts();
  void show_lamp();
  void show_devices();
  void ask();
  [[nodiscard]] std::optional<DimmerSetting> chosen() const;

  Lamp& lamp_;
  QLabel *device_label_, *control_label_, *level_label_, *state_;
  QComboBox *device_, *control_;
  QLineEdit* report_;
  QPushButton* look_;
  QSlider* slider_;
  IntegerField* level_;
};

}  // namespace alltact
