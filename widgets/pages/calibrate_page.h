// The page Calibrate: the steps lens, finger, presses, mapping and verdict, and the check of an
// existing calibration.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/check_page.h"
#include "widgets/calibrating/finger_page.h"
#include "widgets/calibrating/lens_page.h"
#include "widgets/calibrating/mapping_page.h"
#include "widgets/calibrating/presses_page.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/page.h"
#include "widgets/widget_base.h"

#include <QStackedWidget>
#include <QToolButton>
#include <QUndoStack>
#include <QVBoxLayout>
#include <array>

namespace alltact {

// Undo and redo buttons, to compare the page before and after the last change.

/// The text names the step to be undone. Disabled while a recording runs: a step may open another
/// source.
class UndoBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  UndoBar(QUndoStack& undo, const LiveSession& session, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  void set_icons();

  QUndoStack& stack_;
  const LiveSession& session_;
  QToolButton *undo_, *redo_;
};

class CalibratePage : public Page {
  Q_OBJECT
 public:
  ///   work_folder: for unnamed files
  ///   program_version: for the record
  CalibratePage(LiveSession& session, QUndoStack& undo, const std::filesystem::path& work_folder,
                const std::string& program_version, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Calibrate"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Calibrate"); }
  /// Takes a press where one can be taken.
  void press_pedal() override { pages_[step_]->press_pedal(); }
  void add_problems(std::vector<Problem>& problems) override;
  /// Call it after the reference has changed.
  void reload() override;
  /// Opens the first step that is not done.
  void begin_next_step() override;
  [[nodiscard]] std::string leads_to() const override;
  [[nodiscard]] bool take_files(const DroppedFiles& dropped) override {
    return pages_[step_]->take_files(dropped);
  }

  [[nodiscard]] PressCollection& collection() { return collection_; }
  [[nodiscard]] CalibrationRun& run() { return run_; }
  [[nodiscard]] const PressForecast& forecast() const { return forecast_; }
  /// The latest check confirmed the calibration.
  [[nodiscard]] bool is_checked() const { return check_->state() == StepState::kDone; }
  /// A calibration was finished, and its verdict page was not opened yet.
  [[nodiscard]] bool has_unseen_verdict() const { return has_unseen_verdict_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  static constexpr std::size_t kSteps = 6, kPressesStep = 2, kVerdictStep = 4;
  void follow();
  void follow_run();
  void show_steps();
  void go_to(std::size_t step);
  void go_on();  ///< to the next step; from the first presses on, it calibrates
  void show_page(std::size_t step);
  /// The step to do next.
  [[nodiscard]] std::size_t due_step() const;
  /// Last step that can be opened: no earlier step lacks anything.
  [[nodiscard]] std::size_t last_open() const;

  LiveSession& session_;
  PressCollection collection_;
  CalibrationRun run_;
  PressForecast forecast_;
  LensPage* lens_;
  FingerPage* finger_;
  PressesPage* presses_;
  MappingPage* mapping_;
  VerdictPage* verdict_;
  CheckPage* check_;
  std::array<StepPage*, kSteps> pages_;
  StepList* steps_;
  QStackedWidget* stack_;
  QVBoxLayout* column_;
  QWidget* foot_;  // Undo and Next: below the page, or in the column next to its image
  QBoxLayout* foot_row_;
  ReservedText* missing_;
  QPushButton* next_;
  std::size_t step_ = 0;
  bool was_calibrating_ = false, has_unseen_verdict_ = false;
  bool follows_due_ = true;      // until the page was shown with the finger that is open
  bool is_constructed_ = false;  // pages emit signals while the constructor runs
};

}  // namespace alltact
