// What somebody says of one press: its ball or its punch, and how deep it is.
#pragma once

#include "widgets/calibrating/press_desk.h"
#include "widgets/controls/number_field.h"
#include "widgets/translated.h"

#include <QLabel>

namespace alltact {

class PressForm : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressForm(PressDesk& desk, QWidget* parent = nullptr);
  /// To be called again when something else is said of it.
  void show_press(const std::string& name);

 private:
  void name_parts();

  PressDesk& desk_;
  std::string shown_;
  QLabel *radius_label_, *depth_label_, *depth_sd_label_, *step_label_;
  NumberField *radius_, *depth_, *depth_sd_, *step_;
};

}  // namespace alltact
