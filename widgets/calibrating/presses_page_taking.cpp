// Taking presses in the step Presses: by a click, a key, a pedal, or automatically.
#include "core/live/source_runner.h"
#include "widgets/calibrating/presses_page.h"
#include "widgets/report/report_words.h"

#include <QApplication>

namespace alltact {

QString PressesPage::take_obstacle() const {
  if (!session_.view()) return tr("There is no live picture: choose a source.");
  if (!collection_.is_ready()) return tr("The presses are being read.");
  if (!collection_.analyser()) return tr("The finger cannot be compared with its reference.");
  const FramePtr& frame = session_.view()->result.frame;
  if (!frame || session_.view()->problem) return tr("The live picture does not fit this finger.");
  return {};
}

void PressesPage::take() {
  if (!take_obstacle().isEmpty()) return;
  refused_.reset();
  live_->freeze(false);
  show_press({});
  const auto taken = taker_.request(monotonic_s());
  if (taken) add_taken(*taken);
  follow_source();
  show_problems();
  show_take();
}

void PressesPage::add_taken(const PressTaker::Taken& taken) {
  taken_name_ = collection_.add({taken.frame});
  taken_frames_ = taken.of;
  live_->flash(tr("Press %1").arg(collection_.presses().size()));
  QApplication::beep();
  show_problems();
  show_take();
}

void PressesPage::follow_source() {
  if (session_.status().source.state != SourceState::kEnded) return;
  if (const auto last = taker_.end()) add_taken(*last);
}

double PressesPage::held_part() const {
  return automatic_->isChecked() ? still_.hold().hold_fraction : taker_.held_part();
}

void PressesPage::hideEvent(QHideEvent* event) {
  taker_.forget();
  forecast_.set_watched(false);
  StepPage::hideEvent(event);
}

void PressesPage::showEvent(QShowEvent* event) {
  StepPage::showEvent(event);
  forecast_.set_watched(true);
}

void PressesPage::press_pedal() {
  if (take_->isEnabled()) take();
}

void PressesPage::watch_contact() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const bool can_take = take_obstacle().isEmpty();
  guided_ = can_take ? guidance_of(result, collection_, forecast_, 0) : PressGuidance();
  const bool is_still = still_.add(guided_.contact, monotonic_s()) && can_take;
  const auto taken =
      taker_.see(can_take ? result.frame : FramePtr(), guided_.contact, monotonic_s());
  guided_.hold_fraction = held_part();
  show_guide();
  if (taken)
    add_taken(*taken);
  else if (is_still && automatic_->isChecked())
    take();
  else
    show_take();
}

QString PressesPage::auto_take_obstacle() const {
  if (!automatic_->isChecked() || !take_obstacle().isEmpty()) return {};
  const FaceContact touch = session_.view()->result.touch;
  switch (still_.hold().state) {
    case HoldState::kNothing:
      return touch == FaceContact::kUnknown
                 ? tr("Waiting: it cannot be seen whether the face is touched.")
                 : tr("Waiting: nothing presses yet.");
    case HoldState::kMoves:
      return tr("Waiting: the contact still moves, or is pressed in deeper.");
    case HoldState::kTaken:
      return tr("Taken. Lift the ball, or move it by 2 mm, for the next one.");
    case HoldState::kHolds:
      break;
  }
  return tr("Holds still.");
}

void PressesPage::show_guide() {
  const bool is_face_seen = guided_.layer_mm > 0;
  guide_->setText(is_face_seen ? guide_words(guided_) : QString());
  guide_->setVisible(is_face_seen);
  const QString why = auto_take_obstacle();
  waiting_reason_->setText(why);
  waiting_reason_->setVisible(!why.isEmpty());
}

void PressesPage::show_take() {
  const QString reason = take_obstacle();
  take_->setEnabled(reason.isEmpty());
  take_reason_->setText(reason);
  take_reason_->setVisible(!reason.isEmpty());
  show_taken();
}

void PressesPage::show_taken() {
  if (taker_.state() != PressTaker::State::kIdle) {
    taken_->setText(waiting_words(taker_.state()));
    return taken_->setVisible(true);
  }
  const bool is_there =
      collection_.find(taken_name_) != nullptr && collection_.is_saved(taken_name_);
  taken_->setVisible(is_there);
  if (!is_there) return;
  const QString name = as_text(taken_name_);
  taken_->setText(
      taken_frames_ > 1
          ? tr("%1 is taken: the mean of %2 pictures held still.").arg(name).arg(taken_frames_)
          : tr("%1 is taken from a single picture; hold ball and finger still for half "
               "a second, and its noise falls to a quarter.")
                .arg(name));
}

}  // namespace alltact
