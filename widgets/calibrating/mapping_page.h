// Step 4, the mapping: solved beside the window, with what can be seen of it.
#pragma once

#include "widgets/calibrating/press_forecast.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/mapping_plot.h"
#include "widgets/plots/press_error_plot.h"
#include "widgets/shell/finger_drawing.h"
#include "widgets/shell/problem_list.h"

#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>

namespace alltact {

class MappingPage : public StepPage {
  Q_OBJECT
 public:
  MappingPage(PressDesk& desk,
              CalibrationRun& run,
              PressForecast& forecast,
              QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Mapping"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return calibrate_; }
  [[nodiscard]] const QPushButton* to_do() const override {
    return run_.is_running() ? nullptr : calibrate_;
  }
  void show_status();

 Q_SIGNALS:
  /// To be shown with its picture.
  void press_wanted(const std::string& name);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void show_progress();
  void show_figures();
  void show_text();
  void connect_chosen();
  void choose();
  void show_plots();
  void show_chosen();
  void show_log();

  PressDesk& desk_;
  CalibrationRun& run_;
  PressForecast& forecast_;
  ProblemList* problems_;
  QPushButton *calibrate_, *stop_;
  QProgressBar* bar_;
  QLabel *progress_, *text_;
  QWidget* running_;  // while it is calibrated
  QListWidget* log_;  // what was done
  ConvergencePlot* convergence_;
  bool was_running_ = false;
  QWidget* figures_;     // of what it came to, or would
  QWidget* chosen_row_;  // of the press that is chosen among the errors
  QLabel* chosen_;
  QPushButton *show_press_, *leave_out_;
  FingerDrawing* drawing_;  // of what a press is, before there are figures
  MappingPlot* mapping_;
  PressErrorPlot* errors_;
  FaceMapPlot *residual_, *sd_;
  std::shared_ptr<const FingerCalibration> shown_;
};

}  // namespace alltact
