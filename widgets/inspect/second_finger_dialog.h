// Dialog for the second finger and its recording.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/shell/fitted_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace alltact {

class SecondFingerDialog : public FittedDialog {
  Q_OBJECT
 public:
  explicit SecondFingerDialog(const std::optional<SecondFinger>& now, QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const alltact::SecondFinger& second);

 private:
  void choose(QLineEdit* line, bool is_folder, const QString& title);
  void show_missing();

  QLabel *intro_, *finger_label_, *recording_label_, *missing_;
  QLineEdit *finger_, *recording_;
  QPushButton *choose_finger_, *choose_video_, *choose_folder_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
