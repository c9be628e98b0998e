// The lamp's brightness in the window: which dimmer, and how bright.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/live/lamp.h"
#include "widgets/translated.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

namespace alltact {

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
