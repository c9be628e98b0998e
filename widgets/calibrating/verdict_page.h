// Step 5, the verdict: what the calibration is worth, and what would make it better.
#pragma once

#include "widgets/accuracy/more_box.h"
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
  /// Calibrates again, or leads to where the missing evidence is gathered.
  [[nodiscard]] const QPushButton* to_do() const override;
  void show_status();
  /// Shows the remarks and the command.
  void unfold() { fold_->setChecked(true); }

 Q_SIGNALS:
  void presses_wanted();
  void check_wanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// What helps where the calibration is not good.
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
  QWidget* figures_;  // below the face; what is unfolded takes its room
  PressErrorPlot* errors_;
  MappingPlot* mapping_;
  QToolButton *fold_, *fold_more_;
  QWidget* folded_;  // remarks and command
  MoreBox* more_;
  QLabel *report_state_, *command_;
  std::shared_ptr<const FingerCalibration> shown_;
  QString shown_findings_;
};

}  // namespace alltact
