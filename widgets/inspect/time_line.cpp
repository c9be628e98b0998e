#include "widgets/inspect/time_line.h"

#include "core/numerics/readable_numbers.h"
#include "widgets/copy_figure.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QToolTip>
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
  auto* column = without_margins(new QVBoxLayout(this));
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  column->addWidget(strip_);
  add_widgets(*row, {play_, earlier_, later_});
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
  connect(strip_, &EventStrip::frame_requested, this,
          [this](std::size_t number) { request(static_cast<int>(number)); });
  say([this] {
    slider_->setAccessibleName(tr("Frame of the recording"));
    slider_->setToolTip(tr("Drag to a frame; arrow keys go frame by frame"));
    number_->setAccessibleName(tr("Current frame"));
    number_->setToolTip(tr("Number of the shown frame, from 1"));
    of_->setText(tr("of %1").arg(QLocale().toString(static_cast<qulonglong>(count_))));
    name_->setAccessibleName(tr("Frame name"));
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

namespace {

constexpr int kMarks = 8;  // px, height of the problems' marks above the plots

int lane_height(const QFontMetrics& metrics) { return metrics.lineSpacing() + 8; }

}  // namespace

EventStrip::EventStrip(QWidget* parent) : Translated(parent) {
  setFocusPolicy(Qt::StrongFocus);
  set_accessible_role(*this, QAccessible::Chart);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  new CopyFigure(*this, [this] { return grab().toImage(); });
  say([this] {
    setAccessibleName(tr("Contacts, problems and depth over time"));
    describe();
    update();
  });
}

void EventStrip::set_summaries(const std::vector<FrameSummary>& summaries, std::size_t count) {
  const std::size_t lanes_before = lanes().size();
  frames_.assign(count, std::nullopt);
  known_ = 0;
  for (const FrameSummary& summary : summaries) {
    if (summary.number >= count) continue;
    frames_[summary.number] = summary;
    ++known_;
  }
  find_events();
  describe();
  if (lanes().size() != lanes_before) updateGeometry();
  update();
}

void EventStrip::set_shown(std::size_t number) {
  if (number == shown_) return;
  shown_ = number;
  update();
}

void EventStrip::find_events() {
  events_.clear();
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (!frames_[i]) continue;
    const FrameSummary* before = i > 0 && frames_[i - 1] ? &*frames_[i - 1] : nullptr;
    const bool begins = frames_[i]->has_contact && (before == nullptr || !before->has_contact);
    const bool is_new_problem =
        !frames_[i]->problem.empty() && (before == nullptr || before->problem.empty());
    if (begins || is_new_problem) events_.push_back(i);
  }
}

QString EventStrip::description() const {
  int contacts = 0, problems = 0;
  const FrameSummary* deepest = nullptr;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (!frames_[i]) continue;
    const bool had_contact = i > 0 && frames_[i - 1] && frames_[i - 1]->has_contact;
    if (frames_[i]->has_contact && !had_contact) ++contacts;
    if (!frames_[i]->problem.empty()) ++problems;
    if (frames_[i]->deepest_mm &&
        (deepest == nullptr || *frames_[i]->deepest_mm > *deepest->deepest_mm))
      deepest = &*frames_[i];
  }
  QStringList parts{tr("%n contact(s)", nullptr, contacts),
                    tr("%n frame(s) with problems", nullptr, problems)};
  if (deepest != nullptr)
    parts << tr("deepest %1 mm in frame %2")
                 .arg(QLocale().toString(*deepest->deepest_mm, 'f', 2))
                 .arg(deepest->number + 1);
  if (known_ < frames_.size())
    parts << tr("%1 of %2 frames measured").arg(known_).arg(frames_.size());
  return joined(parts);
}

void EventStrip::describe() { set_accessible_description(*this, description()); }

std::vector<EventStrip::Lane> EventStrip::lanes() const {
  std::vector<Lane> all{{[] { return tr("Depth, mm"); }, &FrameSummary::deepest_mm},
                        {[] { return tr("Area, mm²"); }, &FrameSummary::area_mm2},
                        {[] { return tr("Force, N"); }, &FrameSummary::force_N}};
  for (Lane& lane : all)
    for (const auto& frame : frames_)
      if (frame && (*frame).*lane.member)
        lane.top = std::max({lane.top, *((*frame).*lane.member), 1e-3});
  all.erase(std::remove_if(all.begin(), all.end(), [](const Lane& lane) { return lane.top == 0; }),
            all.end());
  for (Lane& lane : all) {
    const double step = round_step(lane.top) / 4;
    lane.top = step * std::ceil(lane.top / step);
  }
  return all;
}

QSize EventStrip::sizeHint() const {
  const int count = std::max(1, static_cast<int>(lanes().size()));
  return {600, kMarks + count * lane_height(fontMetrics())};
}

/// Area of the plots, right of their names.
QRect EventStrip::plots() const {
  int names = 0;
  for (const Lane& lane : lanes())
    names = std::max(names, fontMetrics().horizontalAdvance(lane.name()));
  const int scale = fontMetrics().horizontalAdvance(QStringLiteral("00.00"));
  return rect().adjusted(names + scale + 14, kMarks, -4, 0);
}

double EventStrip::x_of(double number) const {
  const QRect room = plots();
  const auto last = static_cast<double>(std::max<std::size_t>(frames_.size(), 2) - 1);
  return room.left() + number / last * room.width();
}

std::size_t EventStrip::number_at(double x) const {
  if (frames_.empty()) return 0;
  const QRect room = plots();
  const double last = static_cast<double>(frames_.size() - 1);
  const double part = (x - room.left()) / std::max(1, room.width());
  return static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, 1.0) * last));
}

void EventStrip::paint_events(QPainter& painter) const {
  const QRect room = plots();
  QColor contact_colour = role_colour(ColourRole::kContact, palette());
  contact_colour.setAlpha(50);
  const QColor problem = meaning_colour(Meaning::kDoubtful, palette());
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (!frames_[i]) continue;
    const auto number = static_cast<double>(i);
    const double from = std::max(x_of(number - 0.5), double(room.left()));
    const double to = std::min(std::max(x_of(number + 0.5), from + 1), double(room.right()));
    if (frames_[i]->has_contact)
      painter.fillRect(QRectF(from, room.top(), to - from, room.height()), contact_colour);
    if (!frames_[i]->problem.empty()) {
      // A wedge, so that the shape differs, not the colour alone.
      QPainterPath mark(QPointF(x_of(number) - 3, 1));
      mark.lineTo(x_of(number) + 3, 1);
      mark.lineTo(x_of(number), kMarks - 1);
      mark.closeSubpath();
      painter.fillPath(mark, problem);
    }
  }
}

void EventStrip::paint_lane(QPainter& painter, const Lane& lane, const QRect& room) const {
  const QRect words(2, room.top(), room.left() - 6, room.height());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, lane.name());
  painter.drawText(words, Qt::AlignRight | Qt::AlignTop, QLocale().toString(lane.top, 'g', 3));
  QColor faint = palette().color(QPalette::WindowText);
  faint.setAlpha(60);
  painter.setPen(QPen(faint, 1));
  painter.drawLine(room.bottomLeft(), room.bottomRight());
  QPainterPath path;
  QPointF last;
  bool is_down = false;  // the path continues from the last point
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const auto value = frames_[i] ? (*frames_[i]).*lane.member : std::nullopt;
    if (!value) {
      is_down = false;
      continue;
    }
    const QPointF at(x_of(static_cast<double>(i)),
                     room.bottom() - *value / lane.top * (room.height() - 3));
    // Of several frames in one pixel column the highest is drawn.
    if (is_down && at.x() - last.x() < 0.5 && at.y() >= last.y()) continue;
    if (is_down) {
      path.lineTo(at);
    } else {
      path.moveTo(at);
      path.lineTo(at + QPointF(0.5, 0));  // makes a single frame visible
    }
    last = at;
    is_down = true;
  }
  painter.setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 1.5));
  painter.drawPath(path);
}

void EventStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto all = lanes();
  const QRect room = plots();
  if (all.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     known_ > 0 ? tr("Depth over time needs a calibration.")
                                : tr("The recording is being analysed."));
    return;
  }
  paint_events(painter);
  const int height = lane_height(fontMetrics());
  for (std::size_t i = 0; i < all.size(); ++i)
    paint_lane(painter, all[i],
               QRect(room.left(), room.top() + static_cast<int>(i) * height, room.width(), height)
                   .adjusted(0, 2, 0, -1));
  const double now = x_of(static_cast<double>(shown_));
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
  painter.drawLine(QPointF(now, 0), QPointF(now, this->height()));
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void EventStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !frames_.empty())
    Q_EMIT frame_requested(number_at(event->position().x()));
}

void EventStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton) && !frames_.empty())
    Q_EMIT frame_requested(number_at(event->position().x()));
}

void EventStrip::keyPressEvent(QKeyEvent* event) {
  if (frames_.empty()) return Translated::keyPressEvent(event);
  const std::size_t last = frames_.size() - 1;
  const auto later = std::upper_bound(events_.begin(), events_.end(), shown_);
  const auto earlier = std::lower_bound(events_.begin(), events_.end(), shown_);
  switch (event->key()) {
    case Qt::Key_Left:
      return Q_EMIT frame_requested(shown_ > 0 ? shown_ - 1 : 0);
    case Qt::Key_Right:
      return Q_EMIT frame_requested(std::min(shown_ + 1, last));
    case Qt::Key_Home:
      return Q_EMIT frame_requested(0);
    case Qt::Key_End:
      return Q_EMIT frame_requested(last);
    case Qt::Key_PageDown:
      if (later != events_.end()) Q_EMIT frame_requested(*later);
      return;
    case Qt::Key_PageUp:
      if (earlier != events_.begin()) Q_EMIT frame_requested(*std::prev(earlier));
      return;
    default:
      Translated::keyPressEvent(event);
  }
}

/// Values of a frame, as a tool tip.
bool EventStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || frames_.empty()) return Translated::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::size_t number = number_at(help->pos().x());
  QStringList lines{tr("Frame %1").arg(number + 1)};
  if (const auto& frame = frames_[number]) {
    for (const Lane& lane : lanes())
      if (const auto value = (*frame).*lane.member)
        lines << labelled(lane.name(), QLocale().toString(*value, 'f', 2));
    if (!frame->problem.empty()) lines << window_sentence(frame->problem);
  }
  QToolTip::showText(help->globalPos(), lines.join(QLatin1Char('\n')), this);
  return true;
}

}  // namespace alltact
