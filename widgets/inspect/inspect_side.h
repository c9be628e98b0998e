// The right-hand side of the place Inspect: how it is shown, points, profile.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/section_plot.h"
#include "widgets/inspect/surface_box.h"
#include "widgets/translated.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <memory>

namespace alltact {

class InspectSide : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit InspectSide(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);

 Q_SIGNALS:
  /// merge_id: of changes that are one step when they follow each other; -1: none.
  void changed(const alltact::InspectOptions& options, const QString& what, int merge_id);

 private:
  [[nodiscard]] QGroupBox* make_view_group();
  [[nodiscard]] QGroupBox* make_points_group();
  [[nodiscard]] QGroupBox* make_profile_group();
  void connect_view();
  void connect_points();
  void name_parts();
  void name_points();
  void change_point(std::optional<cv::Point2d> InspectOptions::*point, cv::Point2d to, int id);
  void lay_line(bool is_across);
  [[nodiscard]] std::optional<cv::Point2d> deepest() const;
  void show_reading();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  QGroupBox *view_group_, *points_group_, *profile_group_;
  QLabel *shown_as_label_, *standpoint_label_, *comparison_label_, *top_label_, *times_label_;
  QComboBox *shown_as_, *standpoint_, *comparison_;
  QDoubleSpinBox *top_, *times_;
  QCheckBox *untouched_, *camera_;
  struct Point {
    std::optional<cv::Point2d> InspectOptions::*member;
    QLabel* label;
    QDoubleSpinBox *u, *v;
  };
  std::array<Point, 2> points_;
  QPushButton *deepest_, *across_, *along_, *clear_;
  QLabel* reading_;
  SectionPlot* profile_;
  SurfaceBox* surface_;
};

}  // namespace alltact
