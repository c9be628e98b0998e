// Taking presses for the step Check, as in the step Presses: while they are held still.
#include "core/live/source_runner.h"
#include "widgets/calibrating/check_page.h"
#include "widgets/value_change.h"

#include <QApplication>

namespace alltact {

QString CheckPage::take_obstacle() const {
  if (!session_.view()) return tr("There is no live picture: choose a source.");
  if (run_.state() == CalibrationState::kNone) return tr("The finger is not calibrated.");
  if (work_.is_running()) return tr("The check is being made.");
  return {};
}

void CheckPage::press_pedal() {
  if (take_->isEnabled()) take();
}

void CheckPage::take() {
  if (!take_obstacle().isEmpty()) return;
  live_->freeze(false);
  const auto taken = taker_.request(monotonic_s());
  if (taken) add_taken(*taken);
  follow_source();
  show_status();
}

void CheckPage::add_taken(const PressTaker::Taken& taken) {
  auto copy = std::make_shared<Frame>(*taken.frame);
  copy->name = "check_" + std::to_string(taken_.size() + 1);
  copy->jpeg.reset();
  auto more = taken_;
  more.push_back(copy);
  set_taken([] { return tr("take a press for the check"); }, std::move(more));
  live_->flash(tr("Press %1").arg(taken_.size()));
  QApplication::beep();
}

void CheckPage::watch() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const auto waited = taker_.state();
  if (const auto taken = taker_.see(result.frame, dark_patch(result), monotonic_s()))
    add_taken(*taken);
  if (taker_.state() != waited) show_status();
}

void CheckPage::follow_source() {
  if (session_.status().source.state != SourceState::kEnded) return;
  if (const auto last = taker_.end()) add_taken(*last);
}

void CheckPage::hideEvent(QHideEvent* event) {
  taker_.forget();
  StepPage::hideEvent(event);
}

void CheckPage::set_taken(const StepWords& what, std::vector<FramePtr> frames) {
  undo_.push(new ValueChange<std::vector<FramePtr>>(
      what,
      taken_,
      std::move(frames),
      [this, folder = folder_](const std::vector<FramePtr>& restored) {
        if (folder != folder_) return;
        taken_ = restored;
        show_status();
      }));
}

void CheckPage::begin_again() {
  set_taken([] { return tr("begin the check again"); }, {});
}

}  // namespace alltact
