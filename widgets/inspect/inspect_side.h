// The right-hand side of the page Inspect: view, points, cross-section, and readings between the
// points.
#pragma once

#include "widgets/inspect/points_box.h"
#include "widgets/inspect/section_plot.h"
#include "widgets/inspect/surface_box.h"
#include "widgets/inspect/view_box.h"
#include "widgets/undo_step.h"

#include <memory>

namespace alltact {

class InspectSide : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit InspectSide(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);
  void set_frame_count(std::size_t count) { view_->set_frame_count(count); }
  [[nodiscard]] SectionPlot& section() const { return *section_; }

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options,
               const alltact::StepWords& what,
               int merge_id);

 private:
  void measure();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  ViewBox* view_;
  PointsBox* points_;
  QGroupBox* section_group_;
  SectionPlot* section_;
  SurfaceBox* surface_;
};

}  // namespace alltact
