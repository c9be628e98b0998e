// What the presses would come to as they are said to be now, worked out beside the window while
// somebody moves outlines, takes presses or leaves them out.
#pragma once

#include "calibration/finger/forecast_calibration.h"
#include "widgets/calibrating/calibration_run.h"

#include <QTimer>

namespace alltact {

class PressForecast : public QObject {
  Q_OBJECT
 public:
  /// How long everything rests before it is worked out.
  static constexpr int kRests_ms = 300;

  PressForecast(const PressDesk& desk, const CalibrationRun& run, QObject* parent = nullptr);

  /// Works only while somebody looks; what is known stays.
  void set_watched(bool is_watched);
  /// Of the presses as they are now; null: not known yet, nothing has changed since the finger was
  /// calibrated, or there is a problem.
  [[nodiscard]] const std::shared_ptr<const FingerCalibration>& result() const { return result_; }
  [[nodiscard]] bool is_working() const { return work_.is_running() || rest_.isActive(); }
  /// Why these presses give no calibration.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  /// The one in use or, before there is one, the one that was forecast last; null: none.
  [[nodiscard]] const FingerCalibration* to_compare_with() const;

 Q_SIGNALS:
  void changed();

 private:
  /// All that the figures depend on.
  struct Presses {
    std::vector<std::shared_ptr<const ReferencedPress>> measured;
    PressSet said;
    bool operator==(const Presses&) const = default;
  };
  void follow();
  void begin();
  [[nodiscard]] Presses present() const;
  [[nodiscard]] bool is_wanted() const;

  const PressDesk& desk_;
  const CalibrationRun& run_;
  bool is_watched_ = false;
  Presses asked_;  // of result_, problem_ or the work that runs
  std::shared_ptr<const FingerCalibration> result_, last_;
  std::filesystem::path folder_;  // of last_
  std::optional<Error> problem_;
  QTimer rest_;
  BackgroundWork work_;
};

}  // namespace alltact
