// Step 4, the mapping from brightness to depth: solved on a background thread, with plots of the
// solution.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/press_plots.h"
#include "widgets/shell/finger_drawing.h"

#include <QProgressBar>
#include <QPushButton>

namespace alltact {

class MappingPage : public StepPage {
  Q_OBJECT
 public:
  MappingPage(PressCollection& collection, CalibrationRun& run, PressForecast& forecast,
              QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Mapping"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return calibrate_; }
  [[nodiscard]] const QPushButton* action_button() const override {
    return run_.is_running() ? nullptr : calibrate_;
  }
  void show_status();

 Q_SIGNALS:
  /// This press is to be shown with its image.
  void press_requested(const std::string& name);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void show_progress();
  [[nodiscard]] QString comparison() const;
  void show_figures();
  void show_text();
  void connect_chosen();
  void choose();
  void show_plots();
  void show_chosen();

  PressCollection& collection_;
  CalibrationRun& run_;
  PressForecast& forecast_;
  QPushButton *calibrate_, *compare_, *stop_;
  QProgressBar* bar_;
  QLabel *progress_, *text_;
  ConvergencePlot* convergence_;
  QWidget* figures_;     // figures of the calibration or of its forecast
  QWidget* chosen_row_;  // row for the press chosen in the error plot
  QLabel* chosen_;
  QPushButton *show_press_, *leave_out_;
  FingerDrawing* drawing_;  // explains a press; visible before there are figures
  MappingPlot* mapping_;
  PressErrorPlot* errors_;
  FaceMapPlot *residual_, *sd_;
  std::shared_ptr<const FingerCalibration> shown_;
};

}  // namespace alltact
