// Health check: whether a calibrated finger still measures as calibrated. Three presses with the
// same ball are compared; a plot shows the history of errors.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/presses/guided_presses.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/panels/image_panel.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/undo_step.h"

#include <QGroupBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QUndoStack>

namespace alltact {

class CheckPage : public StepPage {
  Q_OBJECT
 public:
  CheckPage(LiveSession& session, PressCollection& collection, const CalibrationRun& run,
            QUndoStack& undo, std::string program_version, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Check"); }
  [[nodiscard]] StepState state() const override;
  void press_pedal() override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return take_; }
  [[nodiscard]] const QPushButton* action_button() const override;
  [[nodiscard]] QString missing() const override { return {}; }
  void show_status();
  [[nodiscard]] const std::vector<CheckEntry>& history() const { return history_; }

 Q_SIGNALS:
  /// A check was added to the finger's history.
  void checked();

 protected:
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_side();
  [[nodiscard]] QString take_obstacle() const;
  void take();
  void add_taken(const PressTaker::Taken& taken);
  void watch();
  void follow_source();
  void check();
  void forget_taken();
  void set_taken(const StepWords& what, std::vector<FramePtr> frames);
  void load_history();
  void write_history(const std::optional<std::string>& content);
  void show_history();
  void show_verdict();
  /// Latest check of the calibration in use; null: none yet.
  [[nodiscard]] const CheckEntry* latest() const;
  [[nodiscard]] QString verdict_words(const CheckEntry& check) const;

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  PressCollection& collection_;
  const CalibrationRun& run_;
  QUndoStack& undo_;
  std::string version_;
  std::filesystem::path folder_;
  std::vector<FramePtr> taken_;
  PressTaker taker_;  // takes presses from the live stream while this page is visible
  std::optional<PressCheck> last_;
  std::vector<CheckEntry> history_;
  ImagePanel* live_;
  QGroupBox *take_group_, *verdict_group_;
  QLabel *how_, *operator_label_, *symbol_, *verdict_, *sentence_;
  QLineEdit* operator_;
  ReservedText* count_;
  QPushButton *take_, *again_, *check_;
  QProgressBar* bar_;
  HistoryPlot* plot_;
  BackgroundWork work_, loading_;
};

}  // namespace alltact
