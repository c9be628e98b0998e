// Forecast of the calibration from the presses as they are now. Runs on a background thread while
// the user moves outlines, adds presses or leaves them out.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "widgets/calibrating/calibration_run.h"

#include <QTimer>

namespace alltact {

class PressForecast : public QObject {
  Q_OBJECT
 public:
  /// Time without changes before a forecast starts.
  static constexpr int kDelay_ms = 300;

  PressForecast(const PressCollection& collection,
                const CalibrationRun& run,
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
    std::vector<std::shared_ptr<const ReferencedPress>> measured;
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

}  // namespace alltact
