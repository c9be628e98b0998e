#include "widgets/inspect/inspect_side.h"

#include "widgets/inspect/face_positions.h"

#include <QVBoxLayout>

namespace alltact {

InspectSide::InspectSide(QWidget* parent)
    : Translated(parent),
      view_(new ViewBox),
      points_(new PointsBox),
      section_group_(new QGroupBox),
      section_(new SectionPlot),
      surface_(new SurfaceBox) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  section_->setMinimumHeight(190);
  (new QVBoxLayout(section_group_))->addWidget(section_);
  for (QWidget* part : std::initializer_list<QWidget*>{view_, points_, section_group_, surface_})
    column->addWidget(part);
  column->addStretch();
  connect(view_, &ViewBox::changed, this, &InspectSide::changed);
  connect(points_, &PointsBox::changed, this, &InspectSide::changed);
  say([this] { section_group_->setTitle(tr("Cross-section")); });
  measure();
}

void InspectSide::set_options(const InspectOptions& options) {
  options_ = options;
  view_->set_options(options);
  points_->set_options(options);
  measure();
}

void InspectSide::show_frame(const std::shared_ptr<const InspectedFrame>& frame) {
  frame_ = frame;
  points_->show_frame(frame);
  measure();
}

void InspectSide::measure() {
  const bool has_depth = frame_ && frame_->result.depth;
  const auto a = has_depth ? pixel_of(*frame_, options_.a) : std::nullopt;
  const auto b = has_depth ? pixel_of(*frame_, options_.b) : std::nullopt;
  surface_->show_readings(frame_, a, b);
  section_->set_other_name(comparand_text(options_.with));
  if (!a || !b) return section_->set_profiles({}, std::nullopt);
  std::optional<Profile> other;
  if (options_.shown_comparison() != Comparison::kNone)
    other = other_profile(*frame_, *options_.a, *options_.b);
  section_->set_profiles(profile_between(frame_->result, frame_->face, frame_->sd_mm, *a, *b),
                         std::move(other));
}

}  // namespace alltact
