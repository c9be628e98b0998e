// Calibrating the finger whose presses lie on a desk: beside the window, stoppable, undoable, and
// with the same bytes as the command line gives.
#pragma once

#include "calibration/checks/finger_worth.h"
#include "calibration/finger/calibrate_finger.h"
#include "widgets/calibrating/press_desk.h"
#include "widgets/report/report_writer.h"

#include <map>

namespace alltact {

/// How the stored calibration stands to the presses.
enum class CalibrationState {
  kNone = 1,
  kCurrent,
  kStale,  ///< made from other presses, other numbers or an older reference
};

class CalibrationRun : public QObject {
  Q_OBJECT
 public:
  CalibrationRun(PressDesk& desk,
                 QUndoStack& undo,
                 std::string program_version,
                 QObject* parent = nullptr);

  /// Looks what the desk's finger was calibrated from. To be called when that changed.
  void reload();
  /// Undoable once it is done. Does nothing while it runs.
  void start();
  /// Keeps the best solution so far, where there is one.
  void stop();
  [[nodiscard]] bool is_running() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }
  /// How the calibration that runs, or ran last, has settled so far.
  [[nodiscard]] std::vector<Round> rounds() const;

  [[nodiscard]] CalibrationState state() const;
  /// What the finger is worth, as its folder stands; nullopt: not known, or there is no finger.
  [[nodiscard]] const std::optional<FingerWorth>& worth() const { return worth_; }
  /// There are presses to calibrate from, and nothing runs.
  [[nodiscard]] bool can_start() const { return !is_running() && desk_.usable_count() > 0; }
  /// With its figures: as it was made, or as the finger keeps it; null where there is none, or
  /// where an earlier version kept too little.
  [[nodiscard]] const std::shared_ptr<const FingerCalibration>& result() const { return result_; }
  /// As it stands in its folder; null where there is none.
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// The presses of a stored calibration are being read again for the plots.
  [[nodiscard]] bool is_recalling() const { return recalling_.is_running(); }
  /// Why they could not be.
  [[nodiscard]] const std::optional<Error>& recall_problem() const { return recall_problem_; }
  /// Does the same in a terminal: as the stored calibration was made where it is current, else as
  /// the next one will be.
  [[nodiscard]] QString command_line() const;
  /// Settings, and what is said of the presses, as the next calibration takes them.
  [[nodiscard]] CalibrationInputs next_inputs() const;

  [[nodiscard]] bool is_writing_report() const { return report_.is_running(); }
  /// The page to open; empty while there is none of this calibration.
  [[nodiscard]] std::filesystem::path report() const;
  /// Why there is none.
  [[nodiscard]] const std::optional<Error>& report_problem() const { return report_.problem(); }

 Q_SIGNALS:
  void changed();

 private:
  class Undo;
  struct HeardRounds;
  using Files = std::map<std::string, std::optional<std::string>>;
  struct Made {
    std::shared_ptr<const FingerCalibration> result;
    std::optional<CalibrationInputs> from;
    FingerPtr finger;
    std::optional<FingerWorth> worth;
  };
  [[nodiscard]] FingerCalibrationInput input_for(const PressSet& said) const;
  void take(const Made& made);
  void take_recalled(const std::shared_ptr<const FingerCalibration>& recalled);
  void recall_residuals_once();
  void restore(const Files& files, const Made& made);

  PressDesk& desk_;
  QUndoStack& undo_;
  std::string version_;
  std::shared_ptr<const FingerCalibration> result_;
  std::optional<CalibrationInputs> from_;
  FingerPtr finger_;
  std::optional<FingerWorth> worth_;
  std::optional<Error> problem_, recall_problem_;
  std::filesystem::path looked_at_;
  bool lacks_residuals_ = false;  // result_ was recalled, and its presses were not read yet
  bool has_report_ = false;
  ReportWriter report_;
  std::shared_ptr<HeardRounds> rounds_;  ///< the calibrating thread has a part in it
  BackgroundWork work_, loading_, recalling_;
};

}  // namespace alltact
