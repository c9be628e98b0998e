// Step 5, the verdict: rated accuracy of the calibration, and what would improve it.
#pragma once

#include "widgets/accuracy/more_data_box.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/mapping_plot.h"
#include "widgets/plots/press_error_plot.h"

#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace alltact {

class VerdictPage : public StepPage {
  Q_OBJECT
 public:
  explicit VerdictPage(CalibrationRun& run, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Verdict"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QWidget* main_control() const override { return print_; }
  /// Calibrates again, or opens the step that provides the missing evidence.
  [[nodiscard]] const QPushButton* action_button() const override;
  void show_status();
  /// Shows the remarks and the command.
  void unfold() { fold_->setChecked(true); }

 Q_SIGNALS:
  void presses_requested();
  void check_requested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// What improves a calibration that is not good.
  enum class Task { kNone, kAgain, kPresses, kCheck };
  [[nodiscard]] Task task() const;
  void do_task();
  void make_head(QVBoxLayout& column);
  void show_head();
  void show_task();
  void make_foot(QVBoxLayout& column);
  void show_next_press();
  void show_remarks();
  void show_folds();
  void print();

  CalibrationRun& run_;
  std::optional<Verdict> known_;
  QLabel *symbol_, *grade_, *findings_, *sentence_, *zones_;
  QPushButton* task_;
  QProgressBar* running_;
  QLabel* next_;
  FaceMapPlot* face_;
  QListWidget* remarks_;
  QPushButton *print_, *report_, *copy_;
  QWidget* figures_;  // below the face plot; hidden while remarks are unfolded
  PressErrorPlot* errors_;
  MappingPlot* mapping_;
  QToolButton *fold_, *fold_more_;
  QWidget* folded_;  // remarks and command
  MoreDataBox* more_;
  QLabel *report_state_, *command_;
  std::shared_ptr<const FingerCalibration> shown_;
  QString shown_findings_;
};

}  // namespace alltact
