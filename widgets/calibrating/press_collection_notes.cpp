// Changes of the press notes, each an undo step.
#include "widgets/calibrating/press_collection.h"
#include "widgets/report/report_words.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

// Consecutive steps with the same id are undone together.
enum MergeId { kRadius = 5'000'000, kOperator, kGrips = 5'100'000 };

}  // namespace

void PressCollection::change(const StepWords& words, PressSet press_set, int merge_id) {
  if (press_set == press_set_ || folder_.empty()) return;
  undo_.push(new ValueChange<PressSet>(
      words,
      press_set_,
      std::move(press_set),
      [this, folder = folder_](const PressSet& value) {
        if (folder == folder_) set_press_set(value);
      },
      merge_id));
}

void PressCollection::change_radii(const StepWords& words, PressSet press_set, int merge_id) {
  // Outlines drawn by hand stay the same: the ball moves within its cone of view.
  if (analyser_ && analyser_->is_perspective())
    for (auto& [name, note] : press_set.notes)
      if (const double before = press_set_.radius_of(name); note.ball_mm && before > 0)
        *note.ball_mm *= press_set.radius_of(name) / before;
  change(words, std::move(press_set), merge_id);
}

void PressCollection::change_note(const StepWords& words,
                                  const std::string& name,
                                  const std::function<void(PressNote&)>& change_it,
                                  int merge_id) {
  PressSet press_set = press_set_;
  PressNote note = press_set.of(name);
  change_it(note);
  press_set.say(name, std::move(note));
  change(words, std::move(press_set), merge_id);
}

void PressCollection::set_radius(double radius_mm) {
  if (!(radius_mm > 0)) return;
  PressSet press_set = press_set_;
  press_set.ball_radius_mm = radius_mm;
  change_radii([] { return tr("change the ball's radius"); }, std::move(press_set), kRadius);
}

void PressCollection::set_radius_of(const std::string& name, double radius_mm) {
  PressSet press_set = press_set_;
  PressNote note = press_set.of(name);
  note.ball_radius_mm.reset();
  if (radius_mm > 0 && radius_mm != press_set.ball_radius_mm) note.ball_radius_mm = radius_mm;
  press_set.say(name, std::move(note));
  change_radii([name] { return tr("change the ball's radius of %1").arg(as_text(name)); },
               std::move(press_set),
               -1);
}

void PressCollection::set_depth_of(const std::string& name, const GivenDepth& depth) {
  change_note(
      [name] { return tr("change the measured depth of %1").arg(as_text(name)); },
      name,
      [&](PressNote& note) { note.depth = depth.mm > 0 ? std::optional(depth) : std::nullopt; });
}

void PressCollection::set_step_of(const std::string& name, double step_mm) {
  change_note(
      [name] { return tr("change the step of %1").arg(as_text(name)); },
      name,
      [&](PressNote& note) { note.step_mm = step_mm > 0 ? std::optional(step_mm) : std::nullopt; });
}

void PressCollection::set_operator(const std::string& name) {
  PressSet press_set = press_set_;
  press_set.operator_name = name;
  change([] { return tr("change the operator"); }, std::move(press_set), kOperator);
}

void PressCollection::set_ball(const std::string& name,
                               const Eigen::Vector3d& centre_mm,
                               int grip) {
  change_note([name] { return tr("move the outline of %1").arg(as_text(name)); },
              name,
              [&](PressNote& note) { note.ball_mm = centre_mm; },
              kGrips + grip);
}

void PressCollection::find_ball_again(const std::string& name) {
  change_note([name] { return tr("find the ball of %1").arg(as_text(name)); },
              name,
              [](PressNote& note) { note.ball_mm.reset(); });
}

void PressCollection::leave_out(const std::string& name, const std::string& because) {
  change_note([name] { return tr("take out %1").arg(as_text(name)); },
              name,
              [&](PressNote& note) { note.excluded = because; });
}

void PressCollection::use_again(const std::string& name) {
  change_note([name] { return tr("put back %1").arg(as_text(name)); },
              name,
              [](PressNote& note) { note.excluded.reset(); });
}

}  // namespace alltact
