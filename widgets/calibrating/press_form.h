// Form for the notes of one press: ball or punch, and measured depth.
#pragma once

#include "widgets/calibrating/press_collection.h"
#include "widgets/controls/number_field.h"
#include "widgets/translated.h"

#include <QLabel>

namespace alltact {

class PressForm : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PressForm(PressCollection& collection, QWidget* parent = nullptr);
  /// Shows the notes of this press; call it again when they change.
  void show_press(const std::string& name);

 private:
  void name_parts();

  PressCollection& collection_;
  std::string shown_;
  QLabel *radius_label_, *depth_label_, *depth_sd_label_, *step_label_;
  NumberField *radius_, *depth_, *depth_sd_, *step_;
};

}  // namespace alltact
