// Table of the readings between A and B, to read and to copy.
#pragma once

#include "widgets/inspect/surface_readings.h"
#include "widgets/translated.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

namespace alltact {

class SurfaceBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit SurfaceBox(QWidget* parent = nullptr);

  /// Null, or without both points: nothing.
  void show_readings(const std::shared_ptr<const InspectedFrame>& frame,
                     const std::optional<cv::Point2d>& a,
                     const std::optional<cv::Point2d>& b);

 private:
  void fill();

  std::vector<SurfaceReading> readings_;
  QLabel* hint_;
  QTableWidget* table_;
  QPushButton *copy_text_, *copy_;
};

}  // namespace alltact
