#include "widgets/panels/frame_strip.h"

#include "widgets/language.h"
#include "widgets/theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr int kBar_px = 18, kMarks_px = 8, kSwatch_px = 10, kGap_px = 6;
constexpr std::array kUses{FrameUse::kRetained,  FrameUse::kRepeatsPose, FrameUse::kRepresented,
                           FrameUse::kInContact, FrameUse::kExcluded,    FrameUse::kUnusable};
/// Of several frames in one column of pixels the first of these is shown: a fault is not lost.
constexpr std::array kShownFirst{FrameUse::kInContact,   FrameUse::kUnusable,
                                 FrameUse::kRetained,    FrameUse::kExcluded,
                                 FrameUse::kRepeatsPose, FrameUse::kRepresented};

}  // namespace

FrameStrip::FrameStrip(QWidget* parent) : Translated(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  set_accessible_role(*this, QAccessible::Chart);
  say([this] {
    setAccessibleName(tr("Frames of the recording"));
    describe();
    updateGeometry();
    update();
  });
}

void FrameStrip::show_report(const ReferenceReport& report) {
  uses_ = report.uses;
  stretches_ = report.stretches;
  rest_.reset();
  if (report.rest_frame >= 0 && static_cast<std::size_t>(report.rest_frame) < uses_.size())
    rest_ = static_cast<std::size_t>(report.rest_frame);
  describe();
  updateGeometry();
  update();
}

QString FrameStrip::name_of(FrameUse use) {
  switch (use) {
    case FrameUse::kRetained:
      return tr("used");
    case FrameUse::kRepeatsPose:
      return tr("same pose as others");
    case FrameUse::kRepresented:
      return tr("represented by neighbouring frames");
    case FrameUse::kInContact:
      return tr("contact, certain or possible");
    case FrameUse::kExcluded:
      return tr("left out by you");
    case FrameUse::kUnusable:
      break;
  }
  return tr("no face or markers");
}

QColor FrameStrip::colour_of(FrameUse use) const {
  switch (use) {
    case FrameUse::kRetained:
      return role_colour(ColourRole::kMeasured, palette());
    case FrameUse::kRepeatsPose:
    case FrameUse::kRepresented: {
      QColor pale = role_colour(ColourRole::kMeasured, palette());
      pale.setAlphaF(use == FrameUse::kRepeatsPose ? 0.5F : 0.25F);
      return pale;
    }
    case FrameUse::kInContact:
      return role_colour(ColourRole::kContact, palette());
    case FrameUse::kExcluded:
      return role_colour(ColourRole::kLeftOut, palette());
    case FrameUse::kUnusable:
      break;
  }
  return meaning_colour(Meaning::kDoubtful, palette());
}

int FrameStrip::count_of(FrameUse use) const {
  return static_cast<int>(std::count(uses_.begin(), uses_.end(), use));
}

std::vector<FrameUse> FrameStrip::shown_uses() const {
  std::vector<FrameUse> shown;
  for (const FrameUse use : kUses)
    if (count_of(use) > 0) shown.push_back(use);
  return shown;
}

void FrameStrip::describe() {
  QStringList parts;
  for (const FrameUse use : shown_uses())
    parts << tr("%1: %2").arg(name_of(use), QLocale().toString(count_of(use)));
  set_accessible_description(*this, joined(parts));
}

QSize FrameStrip::sizeHint() const {
  const int line = fontMetrics().height();
  return {240, kMarks_px + kBar_px + static_cast<int>(shown_uses().size()) * (line + 2) + kGap_px};
}

QSize FrameStrip::minimumSizeHint() const { return {120, sizeHint().height()}; }

QRect FrameStrip::bar() const { return {0, kMarks_px, width(), kBar_px}; }

std::optional<std::size_t> FrameStrip::frame_at(int x) const {
  if (uses_.empty() || x < 0 || x >= width()) return std::nullopt;
  return static_cast<std::size_t>(x) * uses_.size() / static_cast<std::size_t>(width());
}

std::optional<std::size_t> FrameStrip::stretch_of(std::size_t frame) const {
  const auto number = static_cast<int>(frame);
  for (std::size_t i = 0; i < stretches_.size(); ++i)
    if (stretches_[i].first <= number && number <= stretches_[i].last) return i;
  return std::nullopt;
}

QString FrameStrip::words_at(int x) const {
  const auto frame = frame_at(x);
  if (!frame) return {};
  if (const auto stretch = stretch_of(*frame))
    return in_window_language(stretches_[*stretch].sentence);
  return (rest_ == frame ? tr("Frame %1, the rest pose: %2") : tr("Frame %1: %2"))
      .arg(QLocale().toString(static_cast<int>(*frame)), name_of(uses_[*frame]));
}

bool FrameStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return Translated::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), words_at(help->pos().x()), this);
  return true;
}

void FrameStrip::mousePressEvent(QMouseEvent* event) {
  const auto frame = frame_at(static_cast<int>(event->position().x()));
  if (!frame) return;
  if (const auto stretch = stretch_of(*frame)) Q_EMIT stretch_clicked(static_cast<int>(*stretch));
}

void FrameStrip::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

void FrameStrip::paintEvent(QPaintEvent* /*event*/) {
  if (uses_.empty()) return;
  QPainter painter(this);
  paint_frames(painter, bar());
  paint_marks(painter, bar());
  paint_legend(painter, bar().bottom() + 1 + kGap_px);
}

void FrameStrip::paint_frames(QPainter& painter, const QRect& bar) const {
  painter.fillRect(bar, palette().base());
  for (int x = bar.left(); x <= bar.right(); ++x) {
    const auto pixels = static_cast<std::size_t>(width());
    const std::size_t first = *frame_at(x);
    const std::size_t end =
        std::max(first + 1, static_cast<std::size_t>(x + 1) * uses_.size() / pixels);
    const auto shown = std::find_first_of(kShownFirst.begin(), kShownFirst.end(),
                                          uses_.begin() + static_cast<std::ptrdiff_t>(first),
                                          uses_.begin() + static_cast<std::ptrdiff_t>(end));
    painter.fillRect(QRect(x, bar.top(), 1, bar.height()), colour_of(*shown));
  }
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(bar.adjusted(0, 0, -1, -1));
}

/// A triangle above the darkest frame of each stretch, and a line at the rest frame.
void FrameStrip::paint_marks(QPainter& painter, const QRect& bar) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const auto x_of = [&](std::size_t frame) {
    return bar.left() +
           (static_cast<double>(frame) + 0.5) * bar.width() / static_cast<double>(uses_.size());
  };
  for (const ReferenceStretch& stretch : stretches_) {
    const double x = x_of(static_cast<std::size_t>(std::max(0, stretch.darkest)));
    constexpr double kHalf = 4;
    QPainterPath triangle({x, bar.top() - 1.0});
    triangle.lineTo(x - kHalf, bar.top() - kMarks_px);
    triangle.lineTo(x + kHalf, bar.top() - kMarks_px);
    triangle.closeSubpath();
    painter.fillPath(triangle, palette().color(QPalette::WindowText));
  }
  if (!rest_) return;
  painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
  painter.drawLine(QPointF(x_of(*rest_), bar.top()), QPointF(x_of(*rest_), bar.bottom()));
}

void FrameStrip::paint_legend(QPainter& painter, int top) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  const int line = fontMetrics().height() + 2;
  int y = top;
  for (const FrameUse use : shown_uses()) {
    const QRect swatch(0, y + (line - kSwatch_px) / 2, kSwatch_px, kSwatch_px);
    painter.fillRect(swatch, palette().base());
    painter.fillRect(swatch, colour_of(use));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRect(kSwatch_px + kGap_px, y, width() - kSwatch_px - kGap_px, line),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     tr("%1: %2").arg(name_of(use), QLocale().toString(count_of(use))));
    y += line;
  }
}

}  // namespace alltact
