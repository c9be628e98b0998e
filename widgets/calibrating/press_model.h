// List model of the presses, sorted by error once there is a calibration, largest first.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/shown_press.h"
#include "widgets/verdict_text.h"

#include <QAbstractListModel>

namespace alltact {

/// State and error of one press, in one line.
[[nodiscard]] QString press_state_text(const CollectedPress& press,
                                       const PressCollection& collection,
                                       const CalibrationRun& run);
/// nullptr where the press is not part of a calibration with figures.
[[nodiscard]] const BallFit* fitted_ball(const CalibrationRun& run, const std::string& press);
[[nodiscard]] const StepFit* fitted_step(const CalibrationRun& run, const std::string& press);

/// Rating of a press by its error, or as refused; nullopt where it is unknown.
[[nodiscard]] std::optional<Meaning> press_meaning(const CollectedPress& press,
                                                   const PressCollection& collection,
                                                   const CalibrationRun& run);

class PressModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kName = Qt::UserRole };

  PressModel(const PressCollection& collection,
             const CalibrationRun& run,
             QObject* parent = nullptr);
  /// -1: no such press.
  [[nodiscard]] int row_of(const std::string& name) const;
  [[nodiscard]] std::string name_at(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  void follow();

  const PressCollection& collection_;
  const CalibrationRun& run_;
  std::vector<std::string> names_;
  mutable PressThumbnails thumbnails_;
};

}  // namespace alltact
