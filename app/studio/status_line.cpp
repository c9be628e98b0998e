#include "app/studio/status_line.h"

#include <QLocale>

namespace alltact {

StatusLine::StatusLine(const LiveSession& session)
    : session_(session),
      delivered_(new QLabel),
      lost_(new QLabel),
      time_(new QLabel),
      age_(new AgeLabel) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a long text must not widen the window
  for (QLabel* label : labels()) {
    label->setContentsMargins(6, 0, 12, 0);
    addWidget(label);
  }
  connect(&session_, &LiveSession::status_ready, this, &StatusLine::follow);
  say([this] {
    delivered_->setAccessibleName(tr("Frames delivered"));
    lost_->setAccessibleName(tr("Frames lost"));
    time_->setAccessibleName(tr("Time of a frame"));
    follow();
  });
}

std::array<QLabel*, 4> StatusLine::labels() const {
  return {delivered_, lost_, age_, time_};
}

void StatusLine::follow() {
  const bool is_open = session_.view() != nullptr;
  for (QLabel* label : labels()) label->setVisible(is_open);
  if (!is_open) return;
  const LiveStatus& status = session_.status();
  const QLocale locale;
  show_source(status.source, status.shown_per_s);
  age_->show_age(status.age_ms);
  time_->setText(tr("%1 ms a frame").arg(locale.toString(session_.times_ms().total, 'f', 1)));
}

void StatusLine::show_source(const SourceStatus& source, double shown_per_s) {
  const QLocale locale;
  delivered_->setText(tr("%1 frames/s, %2 delivered, %3 shown a second")
                          .arg(locale.toString(source.frames_per_s, 'f', 1),
                               locale.toString(static_cast<qulonglong>(source.delivered)),
                               locale.toString(shown_per_s, 'f', 1)));
  const std::uint64_t damaged = source.camera ? source.camera->counts.damaged : 0;
  lost_->setText(tr("%n frame(s) lost", nullptr, static_cast<int>(source.missing + damaged)));
}

}  // namespace alltact
