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

/// A flat sensor without a camera file is described by the size of a pixel on its face and by its
/// untouched image, which is then installed as well.
class NewFingerDialog : public FittedDialog {
  Q_OBJECT
 public:
  explicit NewFingerDialog(QWidget* parent = nullptr);
  [[nodiscard]] NewFinger description() const;
  /// Fills in known values; values of 0 and empty paths are unknown.
  void set_description(const NewFinger& known);
  /// Asks first where something was typed.
  void reject() override;

 Q_SIGNALS:
  void made(const QString& folder);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// All that can be entered, as text.
  [[nodiscard]] QStringList entries() const;
  /// With the field that each is about.
  [[nodiscard]] std::vector<std::pair<Problem, QWidget*>> missing() const;
  [[nodiscard]] QWidget* with_button(QLineEdit* line, QPushButton* button);
  void show_kind();
  void choose_folder();
  void make();

  QFormLayout* form_;
  QLineEdit *folder_, *camera_, *image_;
  QPushButton *choose_folder_, *choose_camera_, *choose_image_;
  QComboBox *kind_, *polarity_;
  NumberField *width_, *layer_, *plane_, *pixel_;
  IntegerField* per_row_;
  QWidget *folder_row_, *camera_row_, *image_row_;
  QLabel* intro_;
  ProblemList* problems_;
  QDialogButtonBox* buttons_;
  QStringList known_;  // the entries that nobody typed
  BackgroundWork work_;
};

}  // namespace alltact
