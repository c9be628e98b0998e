// How the program looks and which language it speaks; every choice shows at once.
#pragma once

#include "widgets/theme.h"
#include "widgets/translated.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>

namespace alltact {

struct Appearance {
  Theme theme = Theme::kSystem;
  QString language;  ///< "en", "de", "zh_CN"; empty: the system's
  bool operator==(const Appearance&) const = default;
};

class SettingsDialog : public Translated<QDialog> {
  Q_OBJECT
 public:
  explicit SettingsDialog(const Appearance& now, QWidget* parent = nullptr);

 Q_SIGNALS:
  void appearance_chosen(const alltact::Appearance& appearance);

 private:
  void tell();

  QLabel *theme_label_, *language_label_;
  QComboBox *theme_, *language_;
  QDialogButtonBox* buttons_;
  bool is_naming_ = false;
};

}  // namespace alltact
