// What somebody says of the presses on a desk, each time as a step that can be undone.
#include "widgets/calibrating/press_desk.h"
#include "widgets/report/report_words.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

// Steps that follow each other and are of one kind are undone together.
enum MergeId { kRadius = 5'000'000, kOperator, kGrips = 5'100'000 };

}  // namespace

void PressDesk::change(const StepWords& words, PressSet said, int merge_id) {
  if (said == said_ || folder_.empty()) return;
  undo_.push(new ValueChange<PressSet>(
      words,
      said_,
      std::move(said),
      [this, folder = folder_](const PressSet& value) {
        if (folder == folder_) set_said(value);
      },
      merge_id));
}

void PressDesk::change_radii(const StepWords& words, PressSet said, int merge_id) {
  // Outlines drawn by hand stay where they are: the same cone, another ball.
  if (looker_ && looker_->is_perspective())
    for (auto& [name, note] : said.notes)
      if (const double before = said_.radius_of(name); note.ball_mm && before > 0)
        *note.ball_mm *= said.radius_of(name) / before;
  change(words, std::move(said), merge_id);
}

void PressDesk::change_note(const StepWords& words,
                            const std::string& name,
                            const std::function<void(PressNote&)>& change_it,
                            int merge_id) {
  PressSet said = said_;
  PressNote note = said.of(name);
  change_it(note);
  said.say(name, std::move(note));
  change(words, std::move(said), merge_id);
}

void PressDesk::set_radius(double radius_mm) {
  if (!(radius_mm > 0)) return;
  PressSet said = said_;
  said.ball_radius_mm = radius_mm;
  change_radii([] { return tr("change the ball's radius"); }, std::move(said), kRadius);
}

void PressDesk::set_radius_of(const std::string& name, double radius_mm) {
  PressSet said = said_;
  PressNote note = said.of(name);
  note.ball_radius_mm.reset();
  if (radius_mm > 0 && radius_mm != said.ball_radius_mm) note.ball_radius_mm = radius_mm;
  said.say(name, std::move(note));
  change_radii([name] { return tr("change the ball's radius of %1").arg(as_text(name)); },
               std::move(said),
               -1);
}

void PressDesk::set_depth_of(const std::string& name, const ToldDepth& depth) {
  change_note(
      [name] { return tr("change the measured depth of %1").arg(as_text(name)); },
      name,
      [&](PressNote& note) { note.depth = depth.mm > 0 ? std::optional(depth) : std::nullopt; });
}

void PressDesk::set_step_of(const std::string& name, double step_mm) {
  change_note(
      [name] { return tr("change the step of %1").arg(as_text(name)); },
      name,
      [&](PressNote& note) { note.step_mm = step_mm > 0 ? std::optional(step_mm) : std::nullopt; });
}

void PressDesk::set_operator(const std::string& name) {
  PressSet said = said_;
  said.operator_name = name;
  change([] { return tr("change the operator"); }, std::move(said), kOperator);
}

void PressDesk::place_ball(const std::string& name, const Eigen::Vector3d& centre_mm, int grip) {
  change_note([name] { return tr("move the outline of %1").arg(as_text(name)); },
              name,
              [&](PressNote& note) { note.ball_mm = centre_mm; },
              kGrips + grip);
}

void PressDesk::find_again(const std::string& name) {
  change_note([name] { return tr("find the ball of %1").arg(as_text(name)); },
              name,
              [](PressNote& note) { note.ball_mm.reset(); });
}

void PressDesk::take_out(const std::string& name, const std::string& because) {
  change_note([name] { return tr("take out %1").arg(as_text(name)); },
              name,
              [&](PressNote& note) { note.excluded = because; });
}

void PressDesk::put_back(const std::string& name) {
  change_note([name] { return tr("put back %1").arg(as_text(name)); },
              name,
              [](PressNote& note) { note.excluded.reset(); });
}

}  // namespace alltact
