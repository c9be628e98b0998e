// The second finger in the page Inspect.
#include "widgets/inspect/gripper_dialog.h"
#include "widgets/inspect/second_finger_dialog.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/value_change.h"

namespace alltact {
void InspectPage::connect_pair() {
  connect(&pair_, &FingerPair::changed, this, [this] {
    if (options_.second) show_frame();
  });
  connect(pair_box_, &PairBox::open_requested, this, &InspectPage::choose_second);
  connect(pair_box_, &PairBox::close_requested, this, [this] { open_second(std::nullopt); });
  connect(pair_box_, &PairBox::pose_requested, this, &InspectPage::choose_pose);
}

void InspectPage::choose_second() {
  auto* dialog = new SecondFingerDialog(options_.second, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SecondFingerDialog::chosen, this, [this](const SecondFinger& second) {
    open_second(second);
  });
  dialog->show();
}

void InspectPage::choose_pose(bool is_second) {
  const FingerMount* known = pair_.mount(is_second);
  if (known == nullptr) return;
  const std::filesystem::path folder = pair_.folder(is_second);
  using Pose = std::optional<RigidTransform>;
  const Pose now = known->gripper_from_camera;
  auto* dialog = new GripperDialog(pair_.name(is_second), now, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &GripperDialog::chosen, this, [this, folder, now](const Pose& chosen) {
    if (chosen == now) return;
    undo_.push(new ValueChange<Pose>(
        [folder] { return tr("place %1 in the gripper").arg(text_of(folder.filename())); },
        now,
        chosen,
        [this, folder](const Pose& requested) { pair_.set_pose(folder, requested); }));
  });
  dialog->show();
}

/// Both fingers are drawn in one 3D view: their gripper poses are known.
bool InspectPage::is_joint_view() const {
  return pair_.has_both_poses() && options_.shown_as == ShownAs::k3d && VtkView::is_supported();
}

void InspectPage::show_second() {
  const auto& frame = pair_.second().frame();
  if (frame && frame->surface) return second_->show_frame(frame);
  second_->show_message(frame                      ? tr("The face was not found in this picture.")
                        : pair_.second().problem() ? tr("Nothing can be shown; above stands why.")
                                                   : tr("The recording is being opened."));
}

void InspectPage::add_pair_problems(std::vector<Problem>& problems) {
  if (const auto problem = pair_.problem()) problems.push_back(Problem::of(*problem));
  if (!options_.second) return;
  if (pair_.second().problem()) problems.push_back(Problem::of(*pair_.second().problem()));
  for (const bool is_second : {false, true}) {
    const FingerMount* mount = pair_.mount(is_second);
    if (mount == nullptr || mount->gripper_from_camera) continue;
    problems.push_back(
        {Meaning::kDoubtful,
         tr("Where the camera of %1 sits in the gripper is not known, so the two fingers are shown "
            "each in its own camera's frame.")
             .arg(pair_.name(is_second)),
         tr("Tell its place and how it is turned."),
         is_second ? tr("Place of &2…") : tr("Place of &1…"),
         [this, is_second] { choose_pose(is_second); }});
  }
}

void InspectPage::open_second(const std::optional<SecondFinger>& second) {
  InspectOptions next = options_;
  next.second = second;
  next.view_pose.reset();  // the frame of reference changes
  change_options(
      next,
      [opens = second.has_value()] {
        return opens ? tr("show a second finger") : tr("close the second finger");
      },
      -1);
}

}  // namespace alltact
