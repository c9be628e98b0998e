#include "app/studio/page_hint.h"

#include "app/studio/help_pages.h"
#include "widgets/theme.h"

#include <QHBoxLayout>
#include <QSettings>

namespace alltact {

PageHint::PageHint(const Tutorial& guide, QWidget* parent)
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
  connect(more_, &QPushButton::clicked, this, &PageHint::help_requested);
  connect(seen_, &QPushButton::clicked, this, [this] {
    QSettings().setValue(key(page_), true);
    follow();
  });
  connect(&guide_, &Tutorial::turned, this, &PageHint::follow);
  say([this] {
    setAccessibleName(tr("What this place is for"));
    more_->setText(tr("How it is &done (F1)"));
    seen_->setText(tr("&Understood"));
    follow();
  });
}

QString PageHint::key(const std::string& page) {
  return QStringLiteral("hints/%1").arg(QString::fromStdString(page));
}

void PageHint::show_for(const std::string& page) {
  page_ = page;
  follow();
}

void PageHint::follow() {
  const bool is_new = !page_.empty() && !QSettings().value(key(page_), false).toBool();
  const HelpLead lead = lead_of(help_text(QString::fromStdString(page_)));
  setVisible(is_new && !guide_.is_on() && !lead.lead.isEmpty());
  text_->setText(without_marks(lead.lead));
}

}  // namespace alltact
