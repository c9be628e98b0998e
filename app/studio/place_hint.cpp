#include "app/studio/place_hint.h"

#include "app/studio/help_pages.h"
#include "widgets/theme.h"

#include <QHBoxLayout>
#include <QSettings>

namespace alltact {

PlaceHint::PlaceHint(const TryGuide& guide, QWidget* parent)
    : Translated(parent),
      guide_(guide),
      text_(new QLabel),
      more_(new QPushButton),
      seen_(new QPushButton) {
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(text_, 1);
  row->addWidget(more_);
  row->addWidget(seen_);
  hide();
  connect(more_, &QPushButton::clicked, this, &PlaceHint::help_wanted);
  connect(seen_, &QPushButton::clicked, this, [this] {
    QSettings().setValue(key(place_), true);
    follow();
  });
  connect(&guide_, &TryGuide::turned, this, &PlaceHint::follow);
  say([this] {
    setAccessibleName(tr("What this place is for"));
    more_->setText(tr("How it is &done (F1)"));
    seen_->setText(tr("&Understood"));
    follow();
  });
}

QString PlaceHint::key(const std::string& place) {
  return QStringLiteral("hints/%1").arg(QString::fromStdString(place));
}

void PlaceHint::show_for(const std::string& place) {
  place_ = place;
  follow();
}

void PlaceHint::follow() {
  const bool is_new = !place_.empty() && !QSettings().value(key(place_), false).toBool();
  const HelpLead lead = lead_of(help_text(QString::fromStdString(place_)));
  setVisible(is_new && !guide_.is_on() && !lead.lead.isEmpty());
  text_->setText(without_marks(lead.lead));
}

}  // namespace alltact
