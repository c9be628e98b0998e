// The second finger in the place Live.
#include "widgets/pair/second_camera_dialog.h"
#include "widgets/places/live_place.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

constexpr int kMotorMergeId = 22000;

}  // namespace

void LivePlace::connect_pair() {
  connect(&pair_, &LivePair::pair_ready, this, &LivePlace::show_pair);
  connect(&pair_, &LivePair::changed, this, &LivePlace::show_pair_state);
  connect(pair_box_, &LivePairBox::open_wanted, this, &LivePlace::choose_second);
  connect(pair_box_, &LivePairBox::close_wanted, this, [this] { open_second(std::nullopt); });
  connect(pair_box_, &LivePairBox::motor_wanted, this, [this](double turns) {
    auto second = pair_.opened();
    if (!second) return;
    second->motor_turns = turns;
    change_second(
        second, [] { return tr("change the motor's position"); }, kMotorMergeId);
  });
}

void LivePlace::set_cameras(const std::vector<FoundCamera>& cameras) {
  start_->set_cameras(cameras);
  cameras_.clear();
  for (const FoundCamera& camera : cameras)
    if (!camera.problem) cameras_ << QString::fromStdString(camera.identity.lasting());
}

void LivePlace::open_second(const std::optional<SecondCamera>& second) {
  change_second(
      second,
      [opens = second.has_value()] {
        return opens ? tr("watch a second finger") : tr("close the second finger");
      },
      -1);
}

void LivePlace::change_second(const std::optional<SecondCamera>& second,
                              const StepWords& what,
                              int merge_id) {
  using Second = std::optional<SecondCamera>;
  if (second == pair_.opened()) return;
  undo_.push(new ValueChange<Second>(
      what,
      pair_.opened(),
      second,
      [this](const Second& wanted) { set_second(wanted); },
      merge_id));
}

void LivePlace::choose_second() {
  auto* dialog = new SecondCameraDialog(pair_.opened(), cameras_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SecondCameraDialog::chosen, this, [this](const SecondCamera& second) {
    open_second(second);
  });
  dialog->show();
}

void LivePlace::set_second(const std::optional<SecondCamera>& second) {
  pair_.open(second);
  if (second && second_panel_ == nullptr) {
    second_panel_ = new PicturePanel(*pair_.second());
    second_panel_->set_options(options_);
    set_layers(*pair_.second());
    pictures_->addWidget(second_panel_, 1);
  }
  if (second_panel_ != nullptr) second_panel_->setVisible(second.has_value());
  show_pair();
  show_pair_state();
}

void LivePlace::set_layers(LiveSession& session) const {
  session.set_layers({options_.depth, options_.faults});
  session.set_depth_top_mm(options_.depth_top_mm);
}

/// While two are shown, each shows what belongs to the other's moment, and not its own newest.
void LivePlace::show_pair() {
  const auto& pair = pair_.pair();
  panel_->show_instead(pair ? pair->views[0] : nullptr);
  if (second_panel_ != nullptr) second_panel_->show_instead(pair ? pair->views[1] : nullptr);
}

void LivePlace::show_pair_state() {
  pair_box_->show_pair();
  const bool is_open = pair_.opened() && pair_.second() != nullptr;
  panel_->set_title(is_open ? QStringLiteral("1: ") + finger_name(session_.status().finger)
                            : QString());
  if (second_panel_ != nullptr)
    second_panel_->set_title(QStringLiteral("2: ") + finger_name(pair_.second()->status().finger));
}

}  // namespace alltact
