// The health check: is a calibrated finger still what it was? Three presses of the same ball tell,
// and the history shows where it is going.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/presses/press_taker.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/panels/picture_panel.h"
#include "widgets/plots/history_plot.h"
#include "widgets/shell/problem_list.h"
#include "widgets/undo_step.h"

#include <QGroupBox>
#include <QProgressBar>
#include <QPushButton>
#include <QUndoStack>

namespace alltact {

class CheckPage : public StepPage {
  Q_OBJECT
 public:
  CheckPage(LiveSession& session,
            PressDesk& desk,
            const CalibrationRun& run,
            QUndoStack& undo,
            std::string program_version,
            QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Check"); }
  [[nodiscard]] StepState state() const override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return take_; }
  [[nodiscard]] const QPushButton* to_do() const override;
  [[nodiscard]] QString missing() const override { return {}; }
  void show_status();
  [[nodiscard]] const std::vector<CheckEntry>& history() const { return history_; }

 Q_SIGNALS:
  /// A check was added to the finger's.
  void checked();

 protected:
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_side();
  [[nodiscard]] QString why_not_take() const;
  void take();
  void keep_taken(const PressTaker::Taken& taken);
  void watch();
  void follow_source();
  void check();
  void begin_again();
  void forget_taken();
  void set_taken(const StepWords& what, std::vector<FramePtr> frames);
  void load_history();
  void write_history(const std::optional<std::string>& content);
  void show_history();
  void show_verdict();
  /// Of the calibration in use; null: it was not checked yet.
  [[nodiscard]] const CheckEntry* latest() const;
  [[nodiscard]] QString verdict_words(const CheckEntry& check) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  PressDesk& desk_;
  const CalibrationRun& run_;
  QUndoStack& undo_;
  std::string version_;
  std::filesystem::path folder_;
  std::vector<FramePtr> taken_;
  PressTaker taker_;  // of the live picture, for as long as it is watched
  std::optional<PressCheck> last_;
  std::vector<CheckEntry> history_;
  ProblemList* problems_;
  PicturePanel* live_;
  QGroupBox *take_group_, *verdict_group_;
  QLabel *how_, *count_, *symbol_, *verdict_, *sentence_;
  QPushButton *take_, *again_, *check_;
  QProgressBar* bar_;
  HistoryPlot* plot_;
  BackgroundWork work_, loading_;
};

}  // namespace alltact
