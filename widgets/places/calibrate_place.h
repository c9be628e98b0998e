// The place Calibrate: lens, finger, presses, mapping, verdict, one after the other, and the check
// whether it still holds.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/check_page.h"
#include "widgets/calibrating/finger_page.h"
#include "widgets/calibrating/lens_page.h"
#include "widgets/calibrating/mapping_page.h"
#include "widgets/calibrating/presses_page.h"
#include "widgets/calibrating/undo_bar.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/places/place.h"

#include <QStackedWidget>
#include <QVBoxLayout>
#include <array>

namespace alltact {

/// What the place needs of the program around it.
struct CalibrateTools {
  LensMeasurer measure_lens;
  std::filesystem::path work_folder;  ///< for files that nobody named
  std::string version;                ///< of the program, for the record
};

class CalibratePlace : public Place {
  Q_OBJECT
 public:
  CalibratePlace(LiveSession& session,
                 QUndoStack& undo,
                 const CalibrateTools& tools,
                 QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Calibrate"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Calibrate"); }
  /// Takes a press where one can be taken.
  void press_pedal() override { pages_[step_]->press_pedal(); }
  void add_problems(std::vector<Problem>& problems) override;
  /// There is another reference.
  void reload() override;
  /// The step that waits: the first that is not done.
  void begin_with_next() override;

  [[nodiscard]] PressDesk& desk() { return desk_; }
  [[nodiscard]] CalibrationRun& run() { return run_; }
  [[nodiscard]] const PressForecast& forecast() const { return forecast_; }
  /// The last check found it as it was calibrated.
  [[nodiscard]] bool is_checked() const { return check_->state() == StepState::kDone; }
  /// A calibration was made here, and nobody has looked at its verdict yet.
  [[nodiscard]] bool has_news() const { return has_news_; }

 private:
  static constexpr std::size_t kSteps = 6, kPressesStep = 2, kVerdictStep = 4;
  void follow();
  void follow_run();
  void show_steps();
  void go_to(std::size_t step);
  void show_page(std::size_t step);
  /// The furthest step that can be gone to: nothing is missing before it.
  [[nodiscard]] std::size_t last_open() const;

  LiveSession& session_;
  PressDesk desk_;
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
  QWidget* foot_;  // below the page, or below the column beside its picture
  QBoxLayout* foot_row_;
  QLabel* missing_;
  QPushButton* next_;
  std::size_t step_ = 0;
  bool was_calibrating_ = false, has_news_ = false;
  bool is_made_ = false;  // signals come before all is there
};

}  // namespace alltact
