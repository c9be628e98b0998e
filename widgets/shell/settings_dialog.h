// Theme and language of the program; every choice takes effect at once.
#pragma once

#include "widgets/controls/devices.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>

namespace alltact {

struct Appearance {
  Theme theme = Theme::kSystem;
  QString language;  ///< "en", "de", "zh_CN"; empty: the system's
  bool operator==(const Appearance&) const = default;
};

class SettingsDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// `pedal` receives its settings and outlives the dialog; null: there is none to set.
  explicit SettingsDialog(const Appearance& now, Pedal* pedal, QWidget* parent = nullptr);

 Q_SIGNALS:
  void appearance_chosen(const alltact::Appearance& appearance);

 private:
  void emit_choice();
  [[nodiscard]] QWidget* make_pedal();
  void show_pedal();

  Pedal* pedal_;
  QLabel *theme_label_, *language_label_, *pedal_label_, *pedal_text_;
  QComboBox *theme_, *language_;
  QPushButton *learn_, *forget_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
