// What somebody says of the presses on a desk, each time as a step that can be undone.
#include "widgets/calibrating/press_desk.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

// Steps that follow each other and are of one kind are undone together.
enum MergeId { kRadius = 5'000'000, kOperator, kGrips = 5'100'000 };

QString text_of(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

void PressDesk::change(const QString& text, PressNotes notes, int merge_id) {
  if (notes == notes_ || folder_.empty()) return;
  undo_.push(new ValueChange<PressNotes>(
      text,
      notes_,
      std::move(notes),
      [this, folder = folder_](const PressNotes& value) {
        if (folder == folder_) set_notes(value);
      },
      merge_id));
}

void PressDesk::change_radii(const QString& text, PressNotes notes, int merge_id) {
  // Outlines drawn by hand stay where they are: the same cone, another ball.
  if (looker_ && looker_->is_perspective())
    for (PlacedBall& ball : notes.balls)
      if (const double before = notes_.radius_of(ball.name); before > 0)
        ball.centre_mm *= notes.radius_of(ball.name) / before;
  change(text, std::move(notes), merge_id);
}

void PressDesk::set_radius(double radius_mm) {
  if (!(radius_mm > 0)) return;
  PressNotes notes = notes_;
  notes.ball_radius_mm = radius_mm;
  change_radii(tr("change the ball's radius"), std::move(notes), kRadius);
}

void PressDesk::set_radius_of(const std::string& name, double radius_mm) {
  PressNotes notes = notes_;
  unsay(notes.other_balls, name);
  if (radius_mm > 0 && radius_mm != notes.ball_radius_mm)
    notes.other_balls.push_back({name, radius_mm});
  change_radii(tr("change the ball's radius of %1").arg(text_of(name)), std::move(notes), -1);
}

void PressDesk::set_depth_of(const std::string& name, const ToldDepth& depth) {
  PressNotes notes = notes_;
  unsay(notes.depths, name);
  if (depth.mm > 0) notes.depths.push_back({name, depth});
  change(tr("change the measured depth of %1").arg(text_of(name)), std::move(notes));
}

void PressDesk::set_step_of(const std::string& name, double step_mm) {
  PressNotes notes = notes_;
  unsay(notes.steps, name);
  if (step_mm > 0) notes.steps.push_back({name, step_mm});
  change(tr("change the step of %1").arg(text_of(name)), std::move(notes));
}

void PressDesk::set_operator(const std::string& name) {
  PressNotes notes = notes_;
  notes.operator_name = name;
  change(tr("change the operator"), std::move(notes), kOperator);
}

void PressDesk::place_ball(const std::string& name, const Eigen::Vector3d& centre_mm, int grip) {
  PressNotes notes = notes_;
  say(notes.balls, PlacedBall{name, centre_mm});
  change(tr("move the outline of %1").arg(text_of(name)), std::move(notes), kGrips + grip);
}

void PressDesk::find_again(const std::string& name) {
  PressNotes notes = notes_;
  unsay(notes.balls, name);
  change(tr("find the ball of %1").arg(text_of(name)), std::move(notes));
}

void PressDesk::take_out(const std::string& name, const std::string& because) {
  PressNotes notes = notes_;
  say(notes.excluded, ExcludedPress{name, because});
  change(tr("take out %1").arg(text_of(name)), std::move(notes));
}

void PressDesk::put_back(const std::string& name) {
  PressNotes notes = notes_;
  unsay(notes.excluded, name);
  change(tr("put back %1").arg(text_of(name)), std::move(notes));
}

}  // namespace alltact
