// The second finger in the page Live.
#include "widgets/pages/live_page.h"
#include "widgets/pair/second_camera_dialog.h"
#include "widgets/value_change.h"

namespace alltact {
namespace {

constexpr int kMotorMergeId = 22000;

}  // namespace

void LivePage::connect_pair() {
  connect(&pair_, &LivePair::pair_ready, this, &LivePage::show_pair);
  connect(&pair_, &LivePair::changed, this, &LivePage::show_pair_state);
  connect(pair_box_, &LivePairBox::open_requested, this, &LivePage::choose_second);
  connect(pair_box_, &LivePairBox::close_requested, this, [this] { open_second(std::nullopt); });
  connect(pair_box_, &LivePairBox::motor_requested, this, [this](double turns) {
    auto second = pair_.opened();
    if (!second) return;
    second->motor_turns = turns;
    change_second(
        second, [] { return tr("change the motor's position"); }, kMotorMergeId);
  });
}

void LivePage::set_cameras(const std::vector<FoundCamera>& cameras) {
  start_->set_cameras(cameras);
  cameras_.clear();
  for (const FoundCamera& camera : cameras)
    if (!camera.problem) cameras_ << QString::fromStdString(camera.identity.stable_name());
}

void LivePage::open_second(const std::optional<SecondCamera>& second) {
  change_second(
      second,
      [opens = second.has_value()] {
        return opens ? tr("watch a second finger") : tr("close the second finger");
      },
      -1);
}

void LivePage::change_second(const std::optional<SecondCamera>& second,
                             const StepWords& what,
                             int merge_id) {
  using Second = std::optional<SecondCamera>;
  if (second == pair_.opened()) return;
  undo_.push(new ValueChange<Second>(
      what,
      pair_.opened(),
      second,
      [this](const Second& requested) { set_second(requested); },
      merge_id));
}

void LivePage::choose_second() {
  auto* dialog = new SecondCameraDialog(pair_.opened(), cameras_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SecondCameraDialog::chosen, this, [this](const SecondCamera& second) {
    open_second(second);
  });
  dialog->show();
}

void LivePage::set_second(const std::optional<SecondCamera>& second) {
  pair_.open(second);
  if (second && second_panel_ == nullptr) {
    second_panel_ = new ImagePanel(*pair_.second());
    second_panel_->set_options(options_);
    set_layers(*pair_.second());
    panels_->addWidget(second_panel_, 1);
  }
  if (second_panel_ != nullptr) second_panel_->setVisible(second.has_value());
  show_pair();
  show_pair_state();
}

void LivePage::set_layers(LiveSession& session) const {
  session.set_layers({options_.depth, options_.faults});
  session.set_depth_top_mm(options_.depth_top_mm);
}

/// Each panel shows its view of the pair instead of its own newest view.
void LivePage::show_pair() {
  const auto& pair = pair_.pair();
  panel_->show_instead(pair ? pair->views[0] : nullptr);
  if (second_panel_ != nullptr) second_panel_->show_instead(pair ? pair->views[1] : nullptr);
}

void LivePage::show_pair_state() {
  pair_box_->show_pair();
  const bool is_open = pair_.opened() && pair_.second() != nullptr;
  panel_->set_title(is_open ? QStringLiteral("1: ") + finger_name(session_.status().finger)
                            : QString());
  if (second_panel_ != nullptr)
    second_panel_->set_title(QStringLiteral("2: ") + finger_name(pair_.second()->status().finger));
}

}  // namespace alltact
