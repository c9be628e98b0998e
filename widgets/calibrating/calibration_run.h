// Calibrating the finger whose presses lie on a desk: beside the window, stoppable, undoable, and
// with the same bytes as the command line gives.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "widgets/calibrating/press_desk.h"

#include <QProcess>
#include <map>

namespace alltact {

/// How the stored calibration stands to the presses.
enum class CalibrationState {
  kNone = 1,
  kCurrent,
  kStale,  ///< made from other presses, or from other things said of them
};

class CalibrationRun : public QObject {
  Q_OBJECT
 public:
  /// program: the command line, which writes the report's pages, so that they are its own bytes
  /// whatever fonts, language and scale this window has; empty where it is not there.
  CalibrationRun(PressDesk& desk,
                 QUndoStack& undo,
                 std::string program_version,
                 std::filesystem::path program,
                 QObject* parent = nullptr);
  ~CalibrationRun() override;

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
  /// With all its figures; null where it was not made since the finger was opened.
  [[nodiscard]] const std::shared_ptr<const FingerCalibration>& result() const { return result_; }
  /// What the finger's folder says of its calibration; null where there is none.
  [[nodiscard]] const std::shared_ptr<const Finger>& finger() const { return finger_; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// Does the same in a terminal: as the stored calibration was made where it is current, else as
  /// the next one will be.
  [[nodiscard]] QString command_line() const;

  [[nodiscard]] bool is_writing_report() const { return process_.state() != QProcess::NotRunning; }
  /// The page to open; empty while there is none of this calibration.
  [[nodiscard]] std::filesystem::path report() const;
  [[nodiscard]] QString report_problem() const;

 Q_SIGNALS:
  void changed();
  /// finger.yaml was written anew.
  void finger_changed();

 private:
  class Undo;
  struct HeardRounds;
  using Files = std::map<std::string, std::optional<std::string>>;
  struct Made {
    std::shared_ptr<const FingerCalibration> result;
    std::optional<CalibrationInputs> from;
    std::shared_ptr<const Finger> finger;
  };
  [[nodiscard]] FingerCalibrationInput input_for(const PressNotes& notes) const;
  void take(const Made& made);
  void write_report();
  void end_report();
  void restore(const Files& files, const Made& made);
  void tell_when_written();

  PressDesk& desk_;
  QUndoStack& undo_;
  std::string version_;
  std::filesystem::path program_;
  std::shared_ptr<const FingerCalibration> result_;
  std::optional<CalibrationInputs> from_;
  std::shared_ptr<const Finger> finger_;
  std::optional<Error> problem_;
  std::filesystem::path looked_at_;
  bool has_report_ = false;
  bool is_program_missing_ = false;
  QString start_problem_;  ///< in the system's words
  QString report_errors_;  ///< what the command line said that wrote it
  QProcess process_;
  int restored_ = 0, told_ = 0;          // counts
  std::shared_ptr<HeardRounds> rounds_;  ///< the calibrating thread has a part in it
  BackgroundWork work_, loading_, writing_;
};

}  // namespace alltact
