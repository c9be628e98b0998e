#include "widgets/panels/force_box.h"

#include "core/numerics/readable_numbers.h"
#include "widgets/live/touch_history.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kForcePlotHeight = 160;

}  // namespace

ContactBox::ContactBox(QWidget* parent) : Translated(parent), text_(wrapped_text()) {
  text_->setTextFormat(Qt::RichText);
  constexpr int kLines = 11;  // of the longest text
  text_->setMinimumHeight(kLines * text_->fontMetrics().lineSpacing());
  text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  (new QVBoxLayout(this))->addWidget(text_);
  say([this] {
    setTitle(tr("Contact"));
    text_->setToolTip(contact_words_help());
    text_->setAccessibleName(tr("Contacts on the finger"));
  });
}

void ContactBox::show_contact(const FrameResult* result, const TouchHistory& history) {
  text_->setText(result != nullptr ? contact_words(*result, &history) : tr("No image yet."));
}

ForceBox::ForceBox(std::function<ShownForce()> ask, QWidget* parent)
    : Translated(parent),
      ask_(std::move(ask)),
      reading_(wrapped_text()),
      zero_(wrapped_text()),
      plot_(new ForcePlot),
      take_zero_(new QPushButton),
      no_zero_(new QPushButton),
      train_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(reading_);
  plot_->setFixedHeight(kForcePlotHeight);
  column->addWidget(plot_);
  column->addWidget(zero_);
  auto* row = new QHBoxLayout;
  row->addWidget(take_zero_);
  row->addWidget(no_zero_);
  row->addStretch();
  column->addLayout(row);
  column->addWidget(train_, 0, Qt::AlignLeft);
  timer_.setSingleShot(true);
  timer_.setInterval(kDrawInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &ForceBox::draw);
  connect(take_zero_, &QPushButton::clicked, this, [this] {
    if (offered_zero_) Q_EMIT zero_requested(*offered_zero_);
  });
  connect(no_zero_, &QPushButton::clicked, this, &ForceBox::no_zero_requested);
  connect(train_, &QPushButton::clicked, this, &ForceBox::training_requested);
  say([this] {
    setTitle(tr("Force"));
    train_->setText(tr("Train the forces…"));
    train_->setToolTip(tr("Makes a force model from a table of markers and a gauge's forces"));
    take_zero_->setText(tr("Re-&zero"));
    no_zero_->setText(tr("&As measured"));
    no_zero_->setToolTip(tr("Forces use the model's own zero again."));
    reading_->setAccessibleName(tr("Force now"));
    zero_->setAccessibleName(tr("Zero of the forces"));
    plot_->setAccessibleName(tr("Force over the last half minute"));
    draw();
  });
}

ForcePlot* ForceBox::take_plot() {
  layout()->removeWidget(plot_);
  return plot_;
}

void ForceBox::schedule_update() {
  if (isVisible() && !timer_.isActive()) timer_.start();
}

void ForceBox::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  draw();
}

void ForceBox::draw() {
  ++drawings_;
  const ShownForce shown = ask_();
  const bool has_forces = shown.history != nullptr && shown.history->has_forces();
  const bool is_any = has_forces || shown.now || shown.has_model;
  reading_->setToolTip(shown.now && !shown.now->in_range
                           ? tr("The force model was not trained on images like this one.")
                           : QString());
  reading_->setText(has_forces || shown.now ? reading_text(shown) : shown.why_none);
  plot_->setVisible(is_any);
  const auto zero = shown.zero ? std::optional(shown.zero->zero) : std::nullopt;
  plot_->set_data(has_forces ? *shown.history : TouchHistory(), zero);
  zero_->setText(is_any ? zero_text(shown) : QString());
  offered_zero_ = shown.is_live && has_forces ? present_zero(*shown.history) : std::nullopt;
  for (QWidget* widget : std::initializer_list<QWidget*>{zero_, take_zero_, no_zero_})
    widget->setVisible(is_any);
  take_zero_->setEnabled(offered_zero_.has_value());
  no_zero_->setEnabled(shown.zero.has_value());
  train_->setEnabled(shown.can_train);
  take_zero_->setToolTip(!shown.is_live ? tr("A recording is shown as it was measured.")
                         : offered_zero_
                             ? tr("From now on, the mean of the last half second is the zero.")
                             : tr("No reading in range can serve as zero."));
}

QString ForceBox::reading_text(const ShownForce& shown) const {
  if (!shown.now) return tr("No force is estimated for this image.");
  const auto zero = shown.zero ? std::optional(shown.zero->zero) : std::nullopt;
  const Force force = zeroed(*shown.now, zero);
  static const std::array kNames{QStringLiteral("Fx"), QStringLiteral("Fy"), QStringLiteral("Fz")};
  QString rows;
  for (Eigen::Index axis = 0; axis < force.axes; ++axis) {
    const std::optional<double> half =
        force.in_range ? std::optional(force.half_95_N[axis]) : std::nullopt;
    rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align='right'><b>%2</b></td></tr>")
                .arg(kNames[static_cast<std::size_t>(axis)],
                     tr("%1 N").arg(number_and_sd(force.force_N[axis], half, 2)));
  }
  const QString note =
      force.in_range ? tr("95 % lie within ±.")
                     : QStringLiteral("<b>%1 %2</b>")
                           .arg(QString(QChar(0x25b2)), tr("Out of range: do not rely on it."));
  return QStringLiteral("<table>%1</table>%2").arg(rows, note);
}

QString ForceBox::zero_text(const ShownForce& shown) const {
  if (!shown.zero) return tr("Zero: the model's own.");
  const ForceZero& zero = shown.zero->zero;
  const QString since = QLocale().toString(shown.zero->since.time(), QStringLiteral("HH:mm:ss"));
  return zero.has_contact ? tr("Zero: the reading of %1, with the finger in contact.").arg(since)
                          : tr("Zero: the reading of %1.").arg(since);
}

namespace {

constexpr double kNoForce = std::numeric_limits<double>::quiet_NaN();  // breaks a line
constexpr double kLeastSpan_N = 1.0;
constexpr double kBetweenPoints_s = 0.05;  // nearer points share a pixel and cost drawing time

}  // namespace

void ForcePlot::set_data(const TouchHistory& history, const std::optional<ForceZero>& zero) {
  history_ = history;
  zero_ = zero;
  rebuild();
}

/// Covers the readings in range with their intervals. Readings out of range count only where there
/// are no others, since they can have any value.
void ForcePlot::set_span() {
  for (const bool is_in_range : {true, false}) {
    double low = 0, top = 0;
    bool is_any = false;
    for (const auto& reading : history_.forces()) {
      if (!reading.force || reading.force->in_range != is_in_range) continue;
      const Force force = zeroed(*reading.force, zero_);
      is_any = true;
      for (Eigen::Index axis = 0; axis < force.axes; ++axis) {
        const double half = is_in_range ? force.half_95_N[axis] : 0.0;
        low = std::min(low, force.force_N[axis] - half);
        top = std::max(top, force.force_N[axis] + half);
      }
    }
    const double step = round_step(std::max(top - low, kLeastSpan_N)) / 4;
    low_N_ = step * std::floor(low / step);
    top_N_ = step * std::ceil(std::max(top, low_N_ + step) / step);
    if (is_any) return;
  }
}

void ForcePlot::draw_contacts() {
  for (const auto& contact : history_.contacts())
    draw_span(contact.from_s, contact.to_s, 26, Qt::SolidPattern);
  for (const auto& slip : history_.slips()) draw_span(slip.from_s, slip.to_s, 90, Qt::BDiagPattern);
}

void ForcePlot::draw_span(double from_s, double to_s, int alpha, Qt::BrushStyle style) {
  const double now = *history_.now_s();
  auto* span = new QCPItemRect(&chart());
  span->setLayer("background");
  span->topLeft->setCoords(std::max(from_s - now, -TouchHistory::kLength_s), top_N_);
  span->bottomRight->setCoords(to_s - now, low_N_);
  span->setPen(Qt::NoPen);
  QColor colour = palette().color(QPalette::Text);
  colour.setAlpha(alpha);
  span->setBrush(QBrush(colour, style));
}

void ForcePlot::draw_axis(int axis) {
  constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};
  const QColor colour = series_colour(axis, palette());
  QColor band = colour;
  band.setAlpha(50);
  std::array<QVector<double>, 5> columns;  // time, force, both ends, out of range
  auto& [times, forces, uppers, lowers, others] = columns;
  std::optional<double> last_s;
  bool had_force = false;
  for (const auto& reading : history_.forces()) {
    const bool is_like_last = had_force == reading.force.has_value();
    if (last_s && is_like_last && reading.time_s - *last_s < kBetweenPoints_s) continue;
    last_s = reading.time_s;
    had_force = reading.force.has_value();
    times << reading.time_s - *history_.now_s();
    const bool has_force = reading.force && axis < reading.force->axes;
    const Force force = has_force ? zeroed(*reading.force, zero_) : Force();
    const double value = force.force_N[axis], half = force.half_95_N[axis];
    const bool is_valid = has_force && force.in_range;
    forces << (is_valid ? value : kNoForce);
    uppers << (is_valid ? value + half : kNoForce);
    lowers << (is_valid ? value - half : kNoForce);
    others << (has_force && !is_valid ? value : kNoForce);
  }
  auto* upper = chart().addGraph();
  auto* lower = chart().addGraph();
  upper->setData(times, uppers, true);
  lower->setData(times, lowers, true);
  upper->setPen(Qt::NoPen);
  lower->setPen(Qt::NoPen);
  upper->setBrush(band);
  upper->setChannelFillGraph(lower);
  auto* unsure = chart().addGraph();
  unsure->setData(times, others, true);
  unsure->setPen(QPen(colour, 1, Qt::DotLine));
  auto* line = chart().addGraph();
  line->setData(times, forces, true);
  line->setPen(QPen(colour, 2, kStyles[static_cast<std::size_t>(axis)]));
  line->setName(axis == 0   ? QStringLiteral("Fx")
                : axis == 1 ? QStringLiteral("Fy")
                            : QStringLiteral("Fz"));
  for (auto* hidden : {upper, lower, unsure}) hidden->removeFromLegend();
}

bool ForcePlot::draw() {
  if (!history_.has_forces()) return false;
  set_span();
  chart().xAxis->setRange(-TouchHistory::kLength_s, 0);
  chart().yAxis->setRange(low_N_, top_N_);
  draw_contacts();
  int axes = 0;
  for (const auto& reading : history_.forces())
    if (reading.force) axes = std::max(axes, reading.force->axes);
  for (int axis = 0; axis < axes; ++axis) draw_axis(axis);
  chart().xAxis->setLabel(tr("Time (s)"));
  chart().yAxis->setLabel(tr("Force (N)"));
  show_legend();
  return true;
}

namespace {

void change_zero(LiveSession& session, QUndoStack& undo, const std::optional<SessionZero>& zero,
                 StepWords what) {
  using Zero = std::optional<SessionZero>;
  undo.push(new ValueChange<Zero>(
      std::move(what), session.force_zero(), zero,
      [&session](const Zero& requested) { session.set_force_zero(requested); }));
}

}  // namespace

void take_zero(LiveSession& session, QUndoStack& undo, const ForceZero& zero) {
  const FingerStatus& finger = session.status().finger;
  if (!finger.finger) return;
  change_zero(
      session, undo,
      SessionZero{zero, QDateTime::currentDateTime(), finger.folder, finger.finger->force_model},
      [] { return ForceBox::tr("re-zero the force"); });
}

void drop_zero(LiveSession& session, QUndoStack& undo) {
  if (session.force_zero())
    change_zero(session, undo, std::nullopt,
                [] { return ForceBox::tr("show the force as measured"); });
}

}  // namespace alltact
