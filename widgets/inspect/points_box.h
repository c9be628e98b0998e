// The two measuring points: their positions and readings.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/translated.h"
#include "widgets/undo_step.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <memory>

#include <opencv2/core.hpp>

namespace alltact {

class PointsBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit PointsBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options,
               const alltact::StepWords& what,
               int merge_id);

 private:
  struct Point {
    std::optional<FacePosition> InspectOptions::*member;
    QLabel* label;
    std::array<NumberField*, 2> boxes;  // along, across
  };
  void connect_points();
  void change_coordinate(const Point& point, std::size_t part, int merge_id);
  void name_parts();
  void set_section_line(bool is_across);
  [[nodiscard]] std::optional<cv::Point2d> deepest() const;
  void show_points();
  void show_reading();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  std::array<Point, 2> points_;
  QPushButton *deepest_, *across_, *along_, *clear_;
  QLabel* reading_;
};

}  // namespace alltact
