#include "widgets/inspect/time_line.h"

#include "widgets/shell/icons.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {

TimeLine::TimeLine(QWidget* parent)
    : Translated(parent),
      play_(new QToolButton),
      earlier_(new QToolButton),
      later_(new QToolButton),
      slider_(new QSlider(Qt::Horizontal)),
      number_(new IntegerField),
      of_(new QLabel),
      name_(new QLabel),
      strip_(new EventStrip) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  column->addWidget(strip_);
  for (QToolButton* button : {play_, earlier_, later_}) row->addWidget(button);
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  row->addWidget(of_);
  row->addSpacing(6);
  row->addWidget(name_);
  connect(play_, &QToolButton::clicked, this, [this] { play(!is_playing()); });
  connect(slider_, &QSlider::valueChanged, this, &TimeLine::request);
  connect(number_, &IntegerField::valueChanged, this, [this](int value) { request(value - 1); });
  connect(&timer_, &QTimer::timeout, this, &TimeLine::go_on);
  connect(earlier_, &QToolButton::clicked, this, [this] { go_to_event(false); });
  connect(later_, &QToolButton::clicked, this, [this] { go_to_event(true); });
  connect(strip_, &EventStrip::frame_requested, this, [this](std::size_t number) {
    request(static_cast<int>(number));
  });
  say([this] {
    slider_->setAccessibleName(tr("Frame of the recording"));
    number_->setAccessibleName(tr("Number of the frame"));
    of_->setText(tr("of %1").arg(QLocale().toString(static_cast<qulonglong>(count_))));
    name_->setAccessibleName(tr("Name of the frame"));
    earlier_->setAccessibleName(tr("Previous contact or problem"));
    later_->setAccessibleName(tr("Next contact or problem"));
    for (QToolButton* button : {earlier_, later_}) button->setToolTip(button->accessibleName());
    show_button();
  });
}

void TimeLine::set_recording(std::size_t count, double frames_per_s) {
  constexpr double kMaxRate_per_s = 30;
  timer_.setInterval(
      static_cast<int>(std::lround(1000 / std::clamp(frames_per_s, 1.0, kMaxRate_per_s))));
  if (count == count_) return;
  count_ = count;
  const QSignalBlocker still(slider_), quiet(number_);
  slider_->setRange(0, static_cast<int>(count) - 1);
  slider_->setPageStep(std::max(1, static_cast<int>(count) / 20));
  number_->setRange(1, static_cast<int>(count));
  of_->setText(tr("of %1").arg(QLocale().toString(static_cast<qulonglong>(count))));
  setEnabled(count > 0);
}

void TimeLine::set_summaries(const std::vector<FrameSummary>& summaries) {
  strip_->set_summaries(summaries, count_);
  const auto& events = strip_->events();
  for (QToolButton* button : {earlier_, later_}) button->setEnabled(!events.empty());
}

void TimeLine::go_to_event(bool is_next) {
  const auto& events = strip_->events();
  const auto later = std::upper_bound(events.begin(), events.end(), shown_);
  const auto earlier = std::lower_bound(events.begin(), events.end(), shown_);
  if (is_next && later != events.end()) request(static_cast<int>(*later));
  if (!is_next && earlier != events.begin()) request(static_cast<int>(*std::prev(earlier)));
}

void TimeLine::begin(std::size_t number) {
  play(false);
  requested_ = shown_ = number;
}

void TimeLine::set_shown(std::size_t number, const QString& name) {
  shown_ = number;
  name_->setText(name);
  strip_->set_shown(number);
  // During a drag the slider is ahead of the shown frame.
  if (!is_playing() && requested_ != number) return;
  const QSignalBlocker still(slider_), quiet(number_);
  slider_->setValue(static_cast<int>(number));
  number_->setValue(static_cast<int>(number) + 1);
}

void TimeLine::request(int number) {
  requested_ = static_cast<std::size_t>(number);
  const QSignalBlocker still(slider_), quiet(number_);
  slider_->setValue(number);
  number_->setValue(number + 1);
  Q_EMIT frame_requested(requested_);
}

void TimeLine::play(bool is_on) {
  if (is_on == is_playing()) return;
  if (is_on) {
    if (shown_ + 1 >= count_) request(0);
    timer_.start();
  } else {
    timer_.stop();
  }
  show_button();
}

void TimeLine::go_on() {
  if (shown_ != requested_) return;  // the last requested frame is not there yet
  if (shown_ + 1 >= count_) return play(false);
  request(static_cast<int>(shown_) + 1);
}

void TimeLine::show_button() {
  play_->setIcon(icon(is_playing() ? QStringLiteral("pause") : QStringLiteral("play"), palette()));
  play_->setAccessibleName(is_playing() ? tr("Pause") : tr("Play"));
  play_->setToolTip(is_playing() ? tr("Pause") : tr("Play"));
  earlier_->setIcon(icon(QStringLiteral("earlier"), palette()));
  later_->setIcon(icon(QStringLiteral("later"), palette()));
}

void TimeLine::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_button();
}

}  // namespace alltact
