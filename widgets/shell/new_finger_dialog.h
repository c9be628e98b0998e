// The assistant that makes a finger's folder: every value with its unit and range, checked where it
// stands.
#pragma once

#include "core/finger/finger.h"
#include "widgets/background_work.h"
#include "widgets/shell/problem_list.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <filesystem>
#include <functional>

namespace alltact {

/// What a new finger is made of.
struct FingerDescription {
  std::filesystem::path folder, camera;
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0, layer_mm = 0, plane_z_mm = 0;
  int per_row = 0;
  Polarity polarity = Polarity::kAuto;
};

/// Makes the folder; runs on a thread of its own.
using FingerMaker = std::function<Status(const FingerDescription&)>;

class NewFingerDialog : public Translated<QDialog> {
  Q_OBJECT
 public:
  explicit NewFingerDialog(FingerMaker maker, QWidget* parent = nullptr);
  [[nodiscard]] FingerDescription description() const;

 Q_SIGNALS:
  void made(const QString& folder);

 private:
  [[nodiscard]] QWidget* with_button(QLineEdit* line, QPushButton* button);
  void show_kind();
  void choose_camera();
  void choose_folder();
  void make();

  FingerMaker maker_;
  QFormLayout* form_;
  QLineEdit *folder_, *camera_;
  QPushButton *choose_folder_, *choose_camera_;
  QComboBox *kind_, *polarity_;
  QDoubleSpinBox *width_, *layer_, *plane_;
  QSpinBox* per_row_;
  QWidget *folder_row_, *camera_row_;
  QLabel* intro_;
  ProblemList* problems_;
  QDialogButtonBox* buttons_;
  BackgroundWork work_;
};

}  // namespace alltact
