#include "widgets/shell/step_list.h"

#include "widgets/shell/icons.h"
#include "widgets/theme.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kStepSymbol = 16;
constexpr int kHeight = 34, kHighHeight = 36;
constexpr int kBesideText = kStepSymbol + 22;  // px of a button

QString state_word(StepState state) {
  switch (state) {
    case StepState::kDone:
      return StepList::tr("done");
    case StepState::kLookAgain:
      return StepList::tr("look again");
    case StepState::kReading:
      return StepList::tr("is being read");
    case StepState::kToDo:
      break;
  }
  return StepList::tr("to do");
}

/// What it is, and below how it stands.
QString broken(QString text) {
  const qsizetype colon = text.lastIndexOf(QLatin1String(": "));
  if (colon >= 0) text[colon + 1] = QLatin1Char('\n');
  return text;
}

}  // namespace

StepList::StepList(QWidget* parent) : Translated(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  say([this] { dress(); });
}

void StepList::make_buttons(std::size_t count) {
  auto* group = new QButtonGroup(this);
  for (std::size_t i = 0; i < count; ++i) {
    auto* button = new QToolButton;
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({kStepSymbol, kStepSymbol});
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    group->addButton(button);
    layout()->addWidget(button);
    buttons_.push_back(button);
    connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT chosen(i); });
  }
}

void StepList::show_steps(const std::vector<Step>& steps, std::size_t current) {
  if (buttons_.empty()) make_buttons(steps.size());
  Q_ASSERT(steps.size() == buttons_.size() && current < steps.size());
  const bool is_new =
      !std::equal(steps.begin(), steps.end(), steps_.begin(), steps_.end(), [](auto& a, auto& b) {
        return a.title == b.title && a.state == b.state && a.is_open == b.is_open &&
               a.why_not == b.why_not;
      });
  steps_ = steps;
  if (is_new) dress();
  buttons_[current]->setChecked(true);
}

void StepList::dress() {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    QToolButton* button = buttons_[i];
    button->setEnabled(step.is_open);
    button->setToolTip(step.is_open ? QString() : step.why_not);
    const QString text = tr("%1 %2: %3").arg(i + 1).arg(step.title, state_word(step.state));
    button->setAccessibleName(text);
    const bool is_done = step.state == StepState::kDone;
    const bool is_known = is_done || step.state == StepState::kLookAgain;
    button->setIcon(
        !is_known
            ? QIcon()
            : QIcon(symbol(is_done ? QStringLiteral("good") : QStringLiteral("doubtful"),
                           meaning_colour(is_done ? Meaning::kGood : Meaning::kDoubtful, palette()),
                           kStepSymbol,
                           devicePixelRatioF())));
  }
  fit();
}

void StepList::fit() {
  int widest = 0, widest_part = 0;
  for (const QToolButton* button : buttons_) {
    const QString text = button->accessibleName();
    widest = std::max(widest, fontMetrics().horizontalAdvance(text));
    for (const QString& part : broken(text).split(QLatin1Char('\n')))
      widest_part = std::max(widest_part, fontMetrics().horizontalAdvance(part));
  }
  const int count = static_cast<int>(buttons_.size());
  const int gaps = layout()->spacing() * (count - 1);
  const bool is_one_line = count * (widest + kBesideText) + gaps <= width();
  for (QToolButton* button : buttons_) {
    const QString text = button->accessibleName();
    button->setText(is_one_line ? text : broken(text));
    button->setFixedHeight(is_one_line ? kHeight : kHighHeight);
    button->setMinimumWidth(widest_part + kBesideText);
  }
}

void StepList::resizeEvent(QResizeEvent* event) {
  Translated::resizeEvent(event);
  fit();
}

void StepList::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) dress();
}

}  // namespace alltact
