// Contact and force in the page Inspect.
#include "widgets/live/zero_change.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/touch/contact_words.h"
#include "widgets/touch/force_words.h"

#include <QVBoxLayout>

namespace alltact {
namespace {

double recorded_s(const RecordingInfo& recording, std::size_t number) {
  if (recording.times_ns && number < recording.times_ns->size())
    return 1e-9 * static_cast<double>((*recording.times_ns)[number]);
  return static_cast<double>(number) / std::max(recording.frames_per_s, 1e-3);
}

}  // namespace

void InspectPage::make_contact(QVBoxLayout& column) {
  contact_->setWordWrap(true);
  contact_->setTextFormat(Qt::RichText);
  contact_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  constexpr int kContactLines = 8;  // constant height while contacts come and go
  contact_->setMinimumHeight(kContactLines * contact_->fontMetrics().lineSpacing());
  contact_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  (new QVBoxLayout(contact_group_))->addWidget(contact_);
  column.addWidget(contact_group_);
  column.addWidget(force_);
  connect(force_, &ForceBox::zero_requested, this, [this](const ForceZero& zero) {
    take_zero(session_, undo_, zero);
  });
  connect(force_, &ForceBox::no_zero_requested, this, [this] { drop_zero(session_, undo_); });
  connect(&session_, &LiveSession::status_ready, force_, &ForceBox::schedule_update);
}

const TouchHistory& InspectPage::touch_history() const {
  return options_.recording.empty() ? session_.touch_history() : played_;
}

void InspectPage::follow_contact() {
  const auto& frame = inspection_.frame();
  const auto& recording = inspection_.recording();
  if (!frame || options_.recording.empty() || !recording) {
    played_.forget();
    last_played_.reset();
  } else if (frame != last_played_) {
    if (last_played_ && frame->number != last_played_->number + 1) played_.forget();
    played_.add(frame->result, recorded_s(*recording, frame->number));
    last_played_ = frame;
  }
  contact_->setText(frame ? contact_words(frame->result, &touch_history()) : tr("No picture yet."));
  force_->schedule_update();
}

ShownForce InspectPage::shown_force() const {
  ShownForce shown;
  shown.is_live = options_.recording.empty();
  if (const auto& frame = inspection_.frame()) shown.now = frame->result.force;
  shown.history = &touch_history();
  if (shown.is_live) shown.zero = session_.force_zero();
  shown.why_none = no_force_reason(session_.status().finger);
  return shown;
}

}  // namespace alltact
