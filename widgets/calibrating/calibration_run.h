// Calibrates the open finger from its collected presses. Runs on a background thread, can be
// stopped and undone, and writes the same bytes as the command line.
#pragma once

#include "calibration/checks/finger_check.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/calibrate_presses.h"
#include "widgets/calibrating/press_collection.h"
#include "widgets/report/calibration_pages.h"
#include "widgets/verdict_text.h"

#include <QTimer>
#include <map>
#include <optional>

namespace alltact {

/// Whether the stored calibration matches the collected presses.
enum class CalibrationState {
  kNone = 1,
  kCurrent,
  kStale,  ///< made from other presses, other settings or an older reference
};

class CalibrationRun : public QObject {
  Q_OBJECT
 public:
  CalibrationRun(PressCollection& collection, QUndoStack& undo, std::string program_version,
                 QObject* parent = nullptr);

  /// Reloads the stored calibration of the open finger. Call it when the finger's folder has
  /// changed.
  void reload();
  /// Calibrates on a background thread. Adds an undo step when done; does nothing while it runs.
  void start();
  /// Compares the current calibration with other methods, for result()->methods and the report.
  void compare();
  /// Not while a report is written, which a comparison that is stopped would leave unwritten.
  [[nodiscard]] bool can_compare() const {
    return can_start() && !is_writing_report() && state() == CalibrationState::kCurrent &&
           now_.inputs->calibration.method == CalibrationMethod::kJoint;
  }
  /// Stops the run and takes its best solution so far, where there is one; a comparison is
  /// discarded.
  void stop();
  [[nodiscard]] bool is_running() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }
  /// Iterations of the current run or, if none runs, of the last one.
  [[nodiscard]] std::vector<Round> rounds() const;

  [[nodiscard]] CalibrationState state() const;
  /// Rated accuracy of the finger as stored in its folder; nullopt: unknown, or no finger is open.
  [[nodiscard]] const std::optional<FingerWorth>& worth() const { return now_.worth; }
  /// There are usable presses, and no calibration runs.
  [[nodiscard]] bool can_start() const { return !is_running() && collection_.usable_count() > 0; }
  /// Calibration with its figures, from the last run or from the finger's folder. Null: none, or an
  /// earlier version stored too little.
  [[nodiscard]] const std::shared_ptr<const FingerCalibration>& result() const {
    return now_.result;
  }
  /// The finger as stored in its folder; null where there is none.
  [[nodiscard]] const FingerPtr& finger() const { return now_.finger; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// The equivalent terminal command: of the stored calibration where it is current, else of the
  /// next one.
  [[nodiscard]] QString command_line() const;
  /// Settings and press notes of the next calibration.
  [[nodiscard]] CalibrationInputs next_inputs() const;

  [[nodiscard]] bool is_writing_report() const { return report_.is_running(); }
  /// Report page to open; empty while this calibration has none.
  [[nodiscard]] std::filesystem::path report() const;
  /// Why there is no report.
  [[nodiscard]] const std::optional<Error>& report_problem() const { return report_.problem(); }

 Q_SIGNALS:
  void changed();

 private:
  class Undo;
  struct SharedRounds;
  using Files = std::map<std::string, std::optional<std::string>>;
  struct Outcome {
    std::shared_ptr<const FingerCalibration> result;
    std::optional<CalibrationInputs> inputs;
    FingerPtr finger;
    std::optional<FingerWorth> worth;
  };
  [[nodiscard]] FingerCalibrationInput input_for(const PressSet& press_set) const;
  /// Of the calibration in the finger's folder.
  [[nodiscard]] FingerCalibrationInput stored_input() const;
  void run(FingerCalibrationInput input);
  void take(const Outcome& made);
  /// Writes `files` on the disk's thread; `replaced` receives those that were there.
  void restore(std::shared_ptr<Files> files, bool has_report, const Outcome& made,
               std::shared_ptr<Files> replaced);

  PressCollection& collection_;
  QUndoStack& undo_;
  std::string version_;
  Outcome now_;
  std::optional<Error> problem_;
  std::filesystem::path loaded_folder_;
  bool has_report_ = false;
  ReportWriter report_;
  std::shared_ptr<SharedRounds> rounds_;  ///< shared with the calibrating thread
  BackgroundWork work_, loading_;
};

// Forecast of the calibration from the presses as they are now. Runs on a background thread while
// the user moves outlines, adds presses or leaves them out.

class PressForecast : public QObject {
  Q_OBJECT
 public:
  /// Time without changes before a forecast starts.
  static constexpr int kDelay_ms = 300;

  PressForecast(const PressCollection& collection, const CalibrationRun& run,
                QObject* parent = nullptr);

  /// Runs only while a watching page is visible; a result is retained.
  void set_watched(bool is_watched);
  /// Forecast from the current presses. Null: not known yet, nothing has changed since the
  /// calibration, or there is a problem.
  [[nodiscard]] const std::shared_ptr<const FingerCalibration>& result() const { return result_; }
  [[nodiscard]] bool is_working() const { return work_.is_running() || delay_.isActive(); }
  /// Why the presses give no calibration.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  /// The calibration in use or, before the first, the last forecast; null: none.
  [[nodiscard]] const FingerCalibration* baseline() const;

 Q_SIGNALS:
  void changed();

 private:
  /// All inputs of a forecast.
  struct Presses {
    std::vector<std::shared_ptr<const MeasuredPress>> measured;
    PressSet press_set;
    bool operator==(const Presses&) const = default;
  };
  void follow();
  void begin();
  [[nodiscard]] Presses present() const;
  [[nodiscard]] bool is_needed() const;

  const PressCollection& collection_;
  const CalibrationRun& run_;
  bool is_watched_ = false;
  Presses requested_;  // inputs of result_, of problem_ or of the running work
  std::shared_ptr<const FingerCalibration> result_, last_;
  std::filesystem::path folder_;  // finger of last_
  std::optional<Error> problem_;
  QTimer delay_;
  BackgroundWork work_;
};

// Sentences about the rated accuracy of the calibration in use, and about the forecast with the
// present presses.

/// Verdict on the calibration in use, as of now. nullopt: there is none, or its evidence is not
/// stored.
[[nodiscard]] std::optional<Verdict> verdict_of(const CalibrationRun& run);

/// Why a calibration has to be repeated, as sentences; empty: it is current, or there is none.
[[nodiscard]] QString recalibration_reason(const CalibrationRun& run);

/// "With the presses as they are now: 0.021 mm, good (in use: 0.024 mm)."; empty: nothing has
/// changed.
[[nodiscard]] QString forecast_text(const PressForecast& forecast, const CalibrationRun& run);

}  // namespace alltact
