#include "widgets/panels/force_box.h"

#include "widgets/touch/contact_words.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kForcePlotHeight = 160;

}  // namespace

ForceBox::ForceBox(std::function<ShownForce()> ask, QWidget* parent)
    : Translated(parent),
      ask_(std::move(ask)),
      reading_(new QLabel),
      zero_(new QLabel),
      plot_(new ForcePlot),
      take_zero_(new QPushButton),
      no_zero_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  for (QLabel* label : {reading_, zero_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  column->addWidget(reading_);
  plot_->setFixedHeight(kForcePlotHeight);
  column->addWidget(plot_);
  column->addWidget(zero_);
  auto* row = new QHBoxLayout;
  row->addWidget(take_zero_);
  row->addWidget(no_zero_);
  row->addStretch();
  column->addLayout(row);
  timer_.setSingleShot(true);
  timer_.setInterval(kDrawInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &ForceBox::draw);
  connect(take_zero_, &QPushButton::clicked, this, [this] {
    if (offered_zero_) Q_EMIT zero_requested(*offered_zero_);
  });
  connect(no_zero_, &QPushButton::clicked, this, &ForceBox::no_zero_requested);
  say([this] {
    setTitle(tr("Force"));
    take_zero_->setText(tr("Re-&zero"));
    no_zero_->setText(tr("&As measured"));
    no_zero_->setToolTip(tr("Forces count from the model's own zero again."));
    reading_->setAccessibleName(tr("Force now"));
    zero_->setAccessibleName(tr("From which zero forces count"));
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
  const bool is_any = has_forces || shown.now;
  reading_->setToolTip(shown.now && !shown.now->in_range
                           ? tr("The force model was trained with nothing like this picture.")
                           : QString());
  reading_->setText(is_any ? reading_text(shown) : shown.why_none);
  plot_->setVisible(has_forces && shown.history->forces().size() > 1);  // a line needs two
  const auto zero = shown.zero ? std::optional(shown.zero->zero) : std::nullopt;
  plot_->set_data(has_forces ? *shown.history : TouchHistory(), zero);
  zero_->setText(is_any ? zero_text(shown) : QString());
  offered_zero_ = shown.is_live && has_forces ? present_zero(*shown.history) : std::nullopt;
  for (QWidget* widget : std::initializer_list<QWidget*>{zero_, take_zero_, no_zero_})
    widget->setVisible(is_any);
  take_zero_->setEnabled(offered_zero_.has_value());
  no_zero_->setEnabled(shown.zero.has_value());
  take_zero_->setToolTip(
      !shown.is_live  ? tr("A recording is shown as it was measured.")
      : offered_zero_ ? tr("The mean of the last half second counts as no force from now on.")
                      : tr("There is no reading in range that could count as zero."));
}

QString ForceBox::reading_text(const ShownForce& shown) const {
  if (!shown.now) return tr("No force is told of this picture.");
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
  return zero.has_contact
             ? tr("Zero: the reading of %1, while something touched the finger.").arg(since)
             : tr("Zero: the reading of %1.").arg(since);
}

}  // namespace alltact
