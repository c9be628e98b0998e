// The assistant that makes a finger's folder: every value with its unit and range, checked in its
// field.
#pragma once

#include "core/finger/finger_store.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <filesystem>
#include <functional>

namespace alltact {

class NewFingerDialog : public FittedDialog {
  Q_OBJECT
 public:
  explicit NewFingerDialog(QWidget* parent = nullptr);
  [[nodiscard]] NewFinger description() const;
  /// Fills in known values; values of 0 and empty paths are unknown.
  void set_description(const NewFinger& known);

 Q_SIGNALS:
  void made(const QString& folder);

 private:
  [[nodiscard]] QWidget* with_button(QLineEdit* line, QPushButton* button);
  void show_kind();
  void choose_folder();
  void make();

  QFormLayout* form_;
  QLineEdit *folder_, *camera_;
  QPushButton *choose_folder_, *choose_camera_;
  QComboBox *kind_, *polarity_;
  NumberField *width_, *layer_, *plane_;
  IntegerField* per_row_;
  QWidget *folder_row_, *camera_row_;
  QLabel* intro_;
  ProblemList* problems_;
  QDialogButtonBox* buttons_;
  BackgroundWork work_;
};

}  // namespace alltact
