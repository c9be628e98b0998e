// Step 5, the verdict: what the calibration is worth, and what would make it better.
#pragma once

#include "widgets/accuracy/more_box.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/plots/face_map_plot.h"

#include <QGroupBox>
#include <QListWidget>
#include <QPushButton>

namespace alltact {

class VerdictPage : public StepPage {
  Q_OBJECT
 public:
  explicit VerdictPage(CalibrationRun& run, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Verdict"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return report_; }
  void show_status();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_next_press();
  void show_remarks();

  CalibrationRun& run_;
  QLabel *symbol_, *grade_, *sentence_, *zones_;
  QGroupBox *next_group_, *remarks_group_;
  QLabel* next_;
  FaceMapPlot* face_;
  QListWidget* remarks_;
  MoreBox* more_;
  QPushButton *report_, *copy_;
  QLabel *report_state_, *command_;
  std::shared_ptr<const FingerCalibration> shown_;
};

}  // namespace alltact
