// Contact and force in the page Live.
#include "widgets/live/zero_change.h"
#include "widgets/pages/live_page.h"
#include "widgets/touch/force_words.h"

#include <QVBoxLayout>

namespace alltact {

void LivePage::make_contact() {
  contact_->setWordWrap(true);
  contact_->setTextFormat(Qt::RichText);
  contact_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // Height of the longest text, constant while contacts come and go.
  constexpr int kContactLines = 8;
  contact_->setMinimumHeight(kContactLines * contact_->fontMetrics().lineSpacing());
  contact_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  (new QVBoxLayout(contact_group_))->addWidget(contact_);
}

void LivePage::connect_force() {
  connect(&session_, &LiveSession::view_ready, force_, &ForceBox::schedule_update);
  connect(force_, &ForceBox::zero_requested, this, [this](const ForceZero& zero) {
    take_zero(session_, undo_, zero);
  });
  connect(force_, &ForceBox::no_zero_requested, this, [this] { drop_zero(session_, undo_); });
}

ShownForce LivePage::shown_force() const {
  ShownForce shown;
  const auto& view = session_.view();
  if (view) shown.now = view->result.force;
  shown.history = &session_.touch_history();
  shown.zero = session_.force_zero();
  shown.why_none = no_force_reason(session_.status().finger);
  return shown;
}

}  // namespace alltact
