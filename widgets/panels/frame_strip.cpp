#include "widgets/panels/frame_strip.h"

#include "core/sensing/face/face_shape.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/inspection.h"
#include "widgets/language.h"
#include "widgets/panels/image_panel.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPointer>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

std::vector<FrameRange> frames_of(const FrameChoice& choice, bool is_used) {
  std::vector<FrameRange> ranges;
  for (const auto& [frame, used] : choice) {
    if (used != is_used) continue;
    if (!ranges.empty() && ranges.back().last + 1 == frame)
      ranges.back().last = frame;
    else
      ranges.push_back({frame, frame});
  }
  return ranges;
}

FrameStrip::FrameStrip(QWidget* parent) : Translated(parent) {
  setFocusPolicy(Qt::StrongFocus);
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
  if (report.uses.size() != uses_.size()) clear_selection();
  reported_ = uses_ = report.uses;
  stretches_ = report.stretches;
  rest_.reset();
  if (report.rest_frame >= 0 && static_cast<std::size_t>(report.rest_frame) < uses_.size())
    rest_ = static_cast<std::size_t>(report.rest_frame);
  describe();
  updateGeometry();
  update();
}

void FrameStrip::show_choice(const FrameChoice& choice) {
  uses_ = reported_;
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    const auto chosen = choice.find(static_cast<int>(i));
    const bool is_out = uses_[i] == FrameUse::kExcluded || uses_[i] == FrameUse::kInContact;
    if (uses_[i] == FrameUse::kUnusable) continue;
    if (chosen == choice.end() ? uses_[i] == FrameUse::kExcluded : chosen->second && is_out)
      uses_[i] = FrameUse::kRetained;
    if (chosen != choice.end() && !chosen->second) uses_[i] = FrameUse::kExcluded;
  }
  describe();
  updateGeometry();
  update();
}

void FrameStrip::select(const FrameRange& frames, int shown) {
  anchor_ = shown - frames.first < frames.last - shown ? frames.last : frames.first;
  shown_ = shown;
  selected_ = frames;
  describe();
  update();
  Q_EMIT selection_changed();
}

void FrameStrip::clear_selection() {
  anchor_ = shown_ = -1;
  selected_.reset();
  describe();
  update();
  Q_EMIT selection_changed();
}

void FrameStrip::move_to(int frame, bool extends) {
  frame = std::clamp(frame, 0, static_cast<int>(uses_.size()) - 1);
  const int anchor = extends && anchor_ >= 0 ? anchor_ : frame;
  select({std::min(anchor, frame), std::max(anchor, frame)}, frame);
  anchor_ = anchor;
  Q_EMIT frame_selected(frame);
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
  const bool is_shown = shown_ >= 0 && static_cast<std::size_t>(shown_) < uses_.size();
  set_accessible_value(*this, is_shown ? words_of(static_cast<std::size_t>(shown_)) : QString());
}

QSize FrameStrip::sizeHint() const {
  const int line = fontMetrics().height();
  return {240, kMarks_px + kBar_px + static_cast<int>(shown_uses().size()) * (line + 2) + kGap_px};
}

QSize FrameStrip::minimumSizeHint() const { return {120, sizeHint().height()}; }

QRect FrameStrip::bar() const { return {0, kMarks_px, width(), kBar_px}; }

double FrameStrip::x_of(int frame) const {
  return bar().left() + (frame + 0.5) * bar().width() / static_cast<double>(uses_.size());
}

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
  if (const auto stretch = stretch_of(*frame); stretch && uses_[*frame] == reported_[*frame])
    return in_window_language(stretches_[*stretch].sentence);
  return words_of(*frame);
}

QString FrameStrip::words_of(std::size_t frame) const {
  return (rest_ == frame ? tr("Frame %1, the rest pose: %2") : tr("Frame %1: %2"))
      .arg(QLocale().toString(static_cast<int>(frame)), name_of(uses_[frame]));
}

bool FrameStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return Translated::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), words_at(help->pos().x()), this);
  return true;
}

/// The darkest frame of the stretch whose triangle is there.
std::optional<int> FrameStrip::darkest_at(QPointF position) const {
  constexpr double kNear_px = 6;
  std::optional<int> nearest;
  if (position.y() >= kMarks_px) return nearest;
  for (const ReferenceStretch& stretch : stretches_) {
    const double away = std::abs(x_of(stretch.darkest) - position.x());
    if (away <= kNear_px && (!nearest || away < std::abs(x_of(*nearest) - position.x())))
      nearest = stretch.darkest;
  }
  return nearest;
}

void FrameStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || event->position().y() > bar().bottom()) return;
  const auto at = frame_at(static_cast<int>(event->position().x()));
  if (!at) return;
  const auto darkest = darkest_at(event->position());
  const int frame = darkest.value_or(static_cast<int>(*at));
  is_dragging_ = true;
  move_to(frame, event->modifiers().testFlag(Qt::ShiftModifier));
  if (const auto stretch = stretch_of(static_cast<std::size_t>(frame)))
    Q_EMIT stretch_clicked(static_cast<int>(*stretch));
}

void FrameStrip::mouseMoveEvent(QMouseEvent* event) {
  if (!is_dragging_ || uses_.empty()) return;
  const int x = std::clamp(static_cast<int>(event->position().x()), 0, width() - 1);
  const int frame = static_cast<int>(*frame_at(x));
  if (frame != shown_) move_to(frame, true);
}

void FrameStrip::mouseReleaseEvent(QMouseEvent* /*event*/) { is_dragging_ = false; }

void FrameStrip::keyPressEvent(QKeyEvent* event) {
  if (uses_.empty()) return Translated::keyPressEvent(event);
  const bool extends = event->modifiers().testFlag(Qt::ShiftModifier);
  const int last = static_cast<int>(uses_.size()) - 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return move_to(shown_ - 1, extends);
    case Qt::Key_Right:
      return move_to(shown_ + 1, extends);
    case Qt::Key_Home:
      return move_to(0, extends);
    case Qt::Key_End:
      return move_to(last, extends);
    case Qt::Key_Delete:
      return Q_EMIT change_requested();
    default:
      Translated::keyPressEvent(event);
  }
}

void FrameStrip::focusInEvent(QFocusEvent* event) {
  Translated::focusInEvent(event);
  update();
}

void FrameStrip::focusOutEvent(QFocusEvent* event) {
  Translated::focusOutEvent(event);
  update();
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
  paint_selection(painter, bar());
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
  for (const ReferenceStretch& stretch : stretches_) {
    const double x = x_of(std::max(0, stretch.darkest));
    constexpr double kHalf = 4;
    QPainterPath triangle({x, bar.top() - 1.0});
    triangle.lineTo(x - kHalf, bar.top() - kMarks_px);
    triangle.lineTo(x + kHalf, bar.top() - kMarks_px);
    triangle.closeSubpath();
    painter.fillPath(triangle, palette().color(QPalette::WindowText));
  }
  if (!rest_) return;
  painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
  const double rest = x_of(static_cast<int>(*rest_));
  painter.drawLine(QPointF(rest, bar.top()), QPointF(rest, bar.bottom()));
}

/// A frame around the selected frames, in two colours that show on any other, and the focus.
void FrameStrip::paint_selection(QPainter& painter, const QRect& bar) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  if (const auto frames = selection()) {
    constexpr double kLeast_px = 5;
    const double frame_px = bar.width() / static_cast<double>(uses_.size());
    QRectF box(bar.left() + frames->first * frame_px, bar.top(),
               (frames->last + 1 - frames->first) * frame_px, bar.height());
    if (box.width() < kLeast_px)
      box = QRectF(box.center().x() - kLeast_px / 2, box.top(), kLeast_px, box.height());
    painter.setPen(QPen(palette().color(QPalette::Base), 3));
    painter.drawRect(box.adjusted(1, 1, -2, -2));
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    painter.drawRect(box.adjusted(1, 1, -2, -2));
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.drawRect(bar.adjusted(1, 1, -1, -1));
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

// The buttons of the strip, and the frame in the image panel.

namespace {

constexpr double kSpotRadius_mm = 3;
const QColor kSpot(255, 184, 0);

/// A circle on the face around the darkest spot of a stretch. Empty: the frame does not show it.
QPolygonF spot_outline(const FaceShape& shape, const ReferenceStretch& stretch) {
  constexpr int kCorners = 36;
  QPolygonF outline;
  for (int i = 0; i < kCorners; ++i) {
    const double turn = 2 * std::numbers::pi * i / kCorners;
    const auto at = pixel_of_position(shape, {stretch.along_mm + kSpotRadius_mm * std::cos(turn),
                                              stretch.across_mm + kSpotRadius_mm * std::sin(turn)});
    if (at) outline << QPointF(at->x(), at->y());
  }
  return outline.size() > kCorners / 2 ? outline : QPolygonF();
}

QString range_text(const FrameRange& frames) {
  const QLocale locale;
  return frames.first == frames.last
             ? FrameChooser::tr("frame %1").arg(locale.toString(frames.first))
             : FrameChooser::tr("frames %1 to %2")
                   .arg(locale.toString(frames.first), locale.toString(frames.last));
}

Overlay spot_overlay(const QPolygonF& outline, const QString& words, bool is_darkest) {
  return [outline, words, is_darkest](QPainter& painter, const ImageTransform& transform) {
    QPolygonF shown;
    for (const QPointF& point : outline) shown << transform.to_widget(point);
    QPainterPath path;
    path.addPolygon(shown);
    path.closeSubpath();
    stroke_over(painter, path, kSpot, 2, is_darkest ? Qt::SolidLine : Qt::DashLine);
    write_next_to(painter, path.boundingRect().bottomRight(), words, kSpot);
  };
}

}  // namespace

FrameChooser::FrameChooser(ImagePanel& panel, QUndoStack& undo, QWidget* parent)
    : Translated(parent),
      panel_(panel),
      undo_(undo),
      strip_(new FrameStrip),
      change_(new QPushButton),
      live_(new QPushButton) {
  auto* column = without_margins(new QVBoxLayout(this));
  add_widgets(*column, {strip_, change_, live_});
  connect(strip_, &FrameStrip::stretch_clicked, this, &FrameChooser::stretch_clicked);
  connect(strip_, &FrameStrip::selection_changed, this, &FrameChooser::name_parts);
  connect(strip_, &FrameStrip::frame_selected, this, &FrameChooser::show_frame);
  connect(strip_, &FrameStrip::change_requested, this, &FrameChooser::change_selected);
  connect(change_, &QPushButton::clicked, this, &FrameChooser::change_selected);
  connect(live_, &QPushButton::clicked, this, &FrameChooser::show_live_image);
  say([this] { name_parts(); });
}

FrameChooser::~FrameChooser() = default;

void FrameChooser::name_parts() {
  const auto frames = strip_->selection();
  change_->setText(!frames             ? tr("Leave &out the selected frames")
                   : are_used(*frames) ? tr("Leave &out %1").arg(range_text(*frames))
                                       : tr("&Use %1").arg(range_text(*frames)));
  change_->setToolTip(tr("Select frames in the strip: drag, or press Shift and an arrow key."));
  const auto& uses = strip_->uses();
  change_->setEnabled(frames &&
                      std::any_of(uses.begin() + frames->first, uses.begin() + frames->last + 1,
                                  [](FrameUse use) { return use != FrameUse::kUnusable; }));
  live_->setText(tr("Show the live i&mage"));
  live_->setEnabled(shown_frame_ >= 0);
}

void FrameChooser::begin(const std::filesystem::path& finger, const std::filesystem::path& video) {
  show_live_image();
  choice_.clear();
  strip_->clear_selection();
  finger_ = finger;
  video_ = video;
  inspection_.reset();
}

void FrameChooser::show_report(const ReferenceReport& report) {
  strip_->show_report(report);
  strip_->show_choice(choice_);
  name_parts();
}

/// Some of them are, or may be if they show a pose of their own.
bool FrameChooser::are_used(const FrameRange& frames) const {
  const auto& uses = strip_->uses();
  return std::any_of(uses.begin() + frames.first, uses.begin() + frames.last + 1, [](FrameUse use) {
    return use == FrameUse::kRetained || use == FrameUse::kRepeatsPose ||
           use == FrameUse::kRepresented;
  });
}

void FrameChooser::change_selected() {
  if (const auto frames = strip_->selection(); frames && change_->isEnabled())
    choose(*frames, !are_used(*frames));
}

void FrameChooser::choose(const FrameRange& frames, bool is_used, bool all_count_as_untouched) {
  FrameChoice after = choice_;
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    const auto use = strip_->uses().at(static_cast<std::size_t>(frame));
    if (use == FrameUse::kUnusable) continue;
    if (!is_used)
      after[frame] = false;
    else if (use == FrameUse::kInContact || all_count_as_untouched)
      after[frame] = true;
    else if (const auto chosen = after.find(frame); chosen != after.end() && !chosen->second)
      after.erase(chosen);
  }
  if (after == choice_) return;
  const auto words = [frames, is_used] {
    return (is_used ? tr("use %1") : tr("leave out %1")).arg(range_text(frames));
  };
  // A step of a recording that is no longer offered changes nothing.
  undo_.push(new ValueChange<FrameChoice>(
      words, choice_, after, [chooser = QPointer(this), video = video_](const FrameChoice& choice) {
        if (chooser && chooser->video_ == video) chooser->apply(choice);
      }));
}

void FrameChooser::apply(const FrameChoice& choice) {
  choice_ = choice;
  strip_->show_choice(choice_);
  name_parts();
  Q_EMIT choice_changed();
}

void FrameChooser::show_stretch(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= strip_->stretches().size()) return;
  const ReferenceStretch& stretch = strip_->stretches()[static_cast<std::size_t>(index)];
  strip_->select({stretch.first, stretch.last}, stretch.darkest);
  show_frame(stretch.darkest);
}

void FrameChooser::show_frame(int frame) {
  if (frame == shown_frame_) return;
  shown_frame_ = frame;
  name_parts();
  const auto number = static_cast<std::size_t>(frame);
  if (inspection_) return inspection_->show_frame(number);
  inspection_ = std::make_unique<Inspection>();
  connect(inspection_.get(), &Inspection::state_changed, this, &FrameChooser::take_frame);
  inspection_->set_finger(finger_);
  inspection_->open(video_, number);
}

void FrameChooser::take_frame() {
  problem_ = inspection_->problem();
  const auto& frame = inspection_->frame();
  if (shown_frame_ < 0 || !frame) return;
  auto view = std::make_shared<LiveView>();
  view->result = frame->result;
  shown_number_ = static_cast<int>(frame->number);
  shown_ = view;
  panel_.freeze(false);
  panel_.show_instead(view);
}

std::vector<Overlay> FrameChooser::marks(const LiveView& view) const {
  if (&view != shown_.get()) return {};
  std::vector<Overlay> marks{
      banner_overlay(tr("Frame %1 of the recording").arg(QLocale().toString(shown_number_)))};
  const auto stretch = strip_->stretch_of(static_cast<std::size_t>(shown_number_));
  if (!stretch || !view.result.shape) return marks;
  const ReferenceStretch& dark = strip_->stretches()[*stretch];
  const QPolygonF outline = spot_outline(*view.result.shape, dark);
  const bool is_darkest = dark.darkest == shown_number_;
  if (!outline.isEmpty())
    marks.push_back(spot_overlay(
        outline,
        is_darkest
            ? tr("darkest spot: %1 % darker").arg(QLocale().toString(100 * dark.darker, 'f', 0))
            : tr("darkest in frame %1").arg(QLocale().toString(dark.darkest)),
        is_darkest));
  return marks;
}

void FrameChooser::show_live_image() {
  shown_frame_ = -1;
  shown_.reset();
  problem_.reset();
  panel_.show_instead(nullptr);
  name_parts();
}

}  // namespace alltact
