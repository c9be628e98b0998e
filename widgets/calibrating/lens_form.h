// Form for the calibration board, and for a window between lens and finger that the board was not
// seen through.
#pragma once

#include "calibration/lens/calibrate_lens.h"
#include "core/camera/flat_port.h"
#include "widgets/controls/number_field.h"
#include "widgets/translated.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>

namespace alltact {

class LensForm : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit LensForm(QWidget* parent = nullptr);
  [[nodiscard]] Board board() const;
  [[nodiscard]] LensSettings settings() const;
  /// nullopt: no window.
  [[nodiscard]] std::optional<FlatPort> port() const;
  /// Why a visible number is refused; empty: none is. board(), settings() and port() then hold the
  /// last valid numbers.
  [[nodiscard]] QString refusal() const;

 Q_SIGNALS:
  /// The board was changed.
  void board_changed();

 private:
  void name_parts();
  void show_port();

  QFormLayout* form_;
  QComboBox *pattern_, *model_;
  IntegerField *columns_, *rows_;
  NumberField *square_, *distance_, *gap_, *plate_, *plate_index_, *medium_index_;
  QCheckBox* has_port_;
  QLabel *pattern_label_, *size_label_, *square_label_, *by_label_, *model_label_, *distance_label_;
  QLabel *gap_label_, *plate_label_, *plate_index_label_, *medium_index_label_;
};

}  // namespace alltact
