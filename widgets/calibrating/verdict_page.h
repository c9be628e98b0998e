// Step 5, the verdict: rated accuracy of the calibration, and what would improve it.
#pragma once

#include "calibration/checks/finger_check.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/study/calibrating_study.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/plot.h"
#include "widgets/plots/press_plots.h"
#include "widgets/report/document.h"
#include "widgets/widget_base.h"

#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

// Depth error of a calibration over its number of presses.

struct PressesPoint {
  int presses = 0;
  double median_mm = 0, p95_mm = 0;
  std::optional<double> real_median_mm;  ///< of held-out presses, with another marker
  bool is_current = false;
};

/// A dot for the median, a whisker to 95 %; squares for the finger's own presses.
class PressesPlot : public Plot {
  Q_OBJECT
 public:
  explicit PressesPlot(QWidget* parent = nullptr);
  /// Ascending by presses.
  void set_points(std::vector<PressesPoint> points);

 protected:
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<PressesPoint> points_;
};

// The benefit of one more press, more frames of each and one more minute to a calibration.

class MoreDataBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit MoreDataBox(QWidget* parent = nullptr);

  /// The calibrated finger; null: none. Results for another calibration are dropped.
  void set_finger(const FingerPtr& finger);
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Null as long as nothing is computed.
  [[nodiscard]] const std::shared_ptr<const CalibratingStudy>& study() const { return study_; }

 private:
  void start();
  void show_state();

  FingerPtr finger_;
  std::shared_ptr<const CalibratingStudy> study_;
  std::optional<Error> problem_;
  QLabel* words_;
  PressesPlot* plot_;
  QPushButton* start_;
  QProgressBar* bar_;
  BackgroundWork work_;
};

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
  [[nodiscard]] QString zones_text() const;
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

// One printable sheet about a calibration, in the window's language, to file with the finger. The
// full report is calibration_report.pdf.

/// GUI thread.
///   command: terminal command that makes the same calibration
///   now: rating as of now; nullopt: as of the calibration
[[nodiscard]] Document verdict_sheet(const FingerCalibration& done, const QString& command,
                                     const std::optional<FingerWorth>& now = std::nullopt);

/// Opens a print dialog for a printer or a PDF file and prints.
void print_sheet(const Document& sheet, QWidget& parent);

}  // namespace alltact
