// The benefit of one more press, more frames of each and one more minute to a calibration.
#pragma once

#include "calibration/study/calibrating_study.h"
#include "widgets/background_work.h"
#include "widgets/plots/presses_plot.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <memory>
#include <optional>

namespace alltact {

class MoreDataBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit MoreDataBox(QWidget* parent = nullptr);

  /// The calibrated finger; null: none. Results for another calibration are dropped.
  void set_finger(const FingerPtr& finger);
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Null as long as nothing is computed.
  [[nodiscard]] const std::shared_ptr<const CalibratingStudy>& study() const { return study_; }

 private:
  void start();
  void show_state();

  FingerPtr finger_;
  std::shared_ptr<const CalibratingStudy> study_;
  std::optional<Error> problem_;
  QLabel* words_;
  PressesPlot* plot_;
  QPushButton* start_;
  QProgressBar* bar_;
  BackgroundWork work_;
};

}  // namespace alltact
