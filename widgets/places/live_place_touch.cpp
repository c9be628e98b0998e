// What the finger feels, in the place Live.
#include "widgets/live/zero_change.h"
#include "widgets/places/live_place.h"
#include "widgets/touch/force_words.h"

#include <QVBoxLayout>

namespace alltact {

void LivePlace::make_contact() {
  contact_->setWordWrap(true);
  contact_->setTextFormat(Qt::RichText);
  contact_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // Room for what it says most, so that nothing jumps while contacts come and go.
  constexpr int kContactLines = 8;
  contact_->setMinimumHeight(kContactLines * contact_->fontMetrics().lineSpacing());
  contact_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  (new QVBoxLayout(contact_group_))->addWidget(contact_);
}

void LivePlace::connect_force() {
  connect(&session_, &LiveSession::view_ready, force_, &ForceBox::news);
  connect(force_, &ForceBox::zero_wanted, this, [this](const ForceZero& zero) {
    take_zero(session_, undo_, zero);
  });
  connect(force_, &ForceBox::no_zero_wanted, this, [this] { drop_zero(session_, undo_); });
}

ShownForce LivePlace::shown_force() const {
  ShownForce shown;
  const auto& view = session_.view();
  if (view) shown.now = view->result.force;
  shown.history = &session_.touch_history();
  shown.zero = session_.force_zero();
  shown.why_none = why_no_force(session_.status().finger);
  return shown;
}

}  // namespace alltact
