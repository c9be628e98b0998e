// The presses as a list to look at: worst first once they are calibrated.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/shown_press.h"
#include "widgets/worth_words.h"

#include <QAbstractListModel>

namespace alltact {

/// What one press is worth, in a line.
[[nodiscard]] QString press_state_text(const DeskPress& press,
                                       const PressDesk& desk,
                                       const CalibrationRun& run);
/// nullptr where the press is not part of the calibration whose figures are known.
[[nodiscard]] const BallFit* fitted_ball(const CalibrationRun& run, const std::string& press);
[[nodiscard]] const StepFit* fitted_step(const CalibrationRun& run, const std::string& press);

/// How good a press is in the calibration, or that it is refused; nullopt where nothing is known.
[[nodiscard]] std::optional<Meaning> press_meaning(const DeskPress& press,
                                                   const PressDesk& desk,
                                                   const CalibrationRun& run);

class PressModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kName = Qt::UserRole };

  PressModel(const PressDesk& desk, const CalibrationRun& run, QObject* parent = nullptr);
  /// -1: there is none.
  [[nodiscard]] int row_of(const std::string& name) const;
  [[nodiscard]] std::string name_at(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  void follow();

  const PressDesk& desk_;
  const CalibrationRun& run_;
  std::vector<std::string> names_;
  mutable PressThumbnails thumbnails_;
};

}  // namespace alltact
