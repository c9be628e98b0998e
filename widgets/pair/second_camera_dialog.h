// Dialog for the second live finger, its camera and the gripper.
#pragma once

#include "widgets/pair/live_pair.h"
#include "widgets/shell/fitted_dialog.h"

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace alltact {

class SecondCameraDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// cameras: identifiers that open them.
  SecondCameraDialog(const std::optional<SecondCamera>& now,
                     const QStringList& cameras,
                     QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const alltact::SecondCamera& second);

 private:
  void name_parts();
  void choose(QWidget* line, bool is_folder, const QString& title, const QString& filter);
  void show_missing();
  [[nodiscard]] SecondCamera entered() const;

  std::optional<SecondCamera> now_;
  QLabel *intro_, *finger_label_, *source_label_, *gripper_label_, *missing_;
  QLineEdit *finger_, *gripper_;
  QComboBox* source_;
  QPushButton *choose_finger_, *choose_source_, *choose_gripper_, *show_, *cancel_;
};

}  // namespace alltact
