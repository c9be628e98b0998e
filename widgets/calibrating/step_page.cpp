#include "widgets/calibrating/step_page.h"

#include "widgets/language.h"
#include "widgets/theme.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kStepSymbol = 16;
constexpr int kHeight = 34, kHighHeight = 36;
constexpr int kTextMargin = kStepSymbol + 22;  // px of a button

QString state_word(StepState state) {
  switch (state) {
    case StepState::kDone:
      return StepList::tr("done");
    case StepState::kOutdated:
      return StepList::tr("check again");
    case StepState::kReading:
      return StepList::tr("is being read");
    case StepState::kToDo:
      break;
  }
  return StepList::tr("to do");
}

}  // namespace

StepList::StepList(QWidget* parent) : Translated(parent) {
  without_margins(new QHBoxLayout(this));
  say([this] { apply_style(); });
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
  if (is_new) apply_style();
  buttons_[current]->setChecked(true);
  // Of buttons that exclude each other Tab goes to the chosen one. Qt sees to that only when a
  // person chooses.
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i]->setFocusPolicy(i == current ? Qt::StrongFocus : Qt::ClickFocus);
}

void StepList::apply_style() {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    QToolButton* button = buttons_[i];
    button->setEnabled(step.is_open);
    button->setToolTip(step.is_open ? tr("Opens this step") : step.why_not);
    button->setAccessibleName(labelled(title(i), state_word(step.state)));
    const bool is_done = step.state == StepState::kDone;
    const bool is_known = is_done || step.state == StepState::kOutdated;
    button->setIcon(
        !is_known
            ? QIcon()
            : QIcon(symbol(is_done ? QStringLiteral("good") : QStringLiteral("doubtful"),
                           meaning_colour(is_done ? Meaning::kGood : Meaning::kDoubtful, palette()),
                           kStepSymbol, devicePixelRatioF())));
  }
  fit();
}

QString StepList::title(std::size_t step) const {
  return tr("%1 %2", "a step's number and title").arg(step + 1).arg(steps_[step].title);
}

void StepList::fit() {
  const QFontMetrics metrics = fontMetrics();
  int widest = 0, widest_part = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    widest = std::max(widest, metrics.horizontalAdvance(buttons_[i]->accessibleName()));
    for (const QString& part : {title(i), state_word(steps_[i].state)})
      widest_part = std::max(widest_part, metrics.horizontalAdvance(part));
  }
  const int count = static_cast<int>(buttons_.size());
  const int gaps = layout()->spacing() * (count - 1);
  const bool is_one_line = count * (widest + kTextMargin) + gaps <= width();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    QToolButton* button = buttons_[i];
    button->setText(is_one_line ? button->accessibleName()
                                : title(i) + QLatin1Char('\n') + state_word(steps_[i].state));
    button->setFixedHeight(is_one_line ? kHeight : kHighHeight);
    button->setMinimumWidth(widest_part + kTextMargin);
  }
}

void StepList::resizeEvent(QResizeEvent* event) {
  Translated::resizeEvent(event);
  fit();
}

void StepList::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) apply_style();
}

std::vector<Problem> StepPage::problems() const {
  std::vector<Problem> problems = problems_;
  for (Problem& problem : problems)  // in the language of now
    if (problem.cause) problem = Problem::of(*problem.cause, problem.meaning);
  return problems;
}

void StepPage::set_problems(std::vector<Problem> problems) {
  problems_ = std::move(problems);
  Q_EMIT problems_changed();
}

SpaceKey::SpaceKey(QWidget& page, std::function<void()> act)
    : QObject(&page), page_(page), act_(std::move(act)) {
  qApp->installEventFilter(this);
}

bool SpaceKey::handles_space(const QWidget& widget) const {
  const QWidget* inner = &widget;
  const auto* line = qobject_cast<const QLineEdit*>(inner);
  if (line != nullptr && qobject_cast<const QAbstractSpinBox*>(line->parentWidget()) != nullptr)
    return false;
  if (line != nullptr || qobject_cast<const QTextEdit*>(inner) != nullptr ||
      qobject_cast<const QPlainTextEdit*>(inner) != nullptr ||
      qobject_cast<const QComboBox*>(inner) != nullptr ||
      qobject_cast<const QMenu*>(inner) != nullptr)
    return true;
  // Step buttons are no exception: they keep the focus after the step was opened.
  return qobject_cast<const QAbstractButton*>(inner) != nullptr && inner != clicked_ &&
         qobject_cast<const StepList*>(inner->parentWidget()) == nullptr;
}

bool SpaceKey::eventFilter(QObject* receiver, QEvent* event) {
  const auto* clicked = qobject_cast<const QWidget*>(receiver);
  if (event->type() == QEvent::MouseButtonPress && clicked != nullptr &&
      (clicked->focusPolicy() & Qt::ClickFocus) != 0)
    clicked_ = receiver;  // the focus may be there already
  if (event->type() == QEvent::FocusIn) {
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason)
      clicked_ = reason == Qt::MouseFocusReason ? receiver : nullptr;
    return false;
  }
  if (event->type() != QEvent::KeyPress) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const auto* widget = qobject_cast<QWidget*>(receiver);
  if (key->key() != Qt::Key_Space || key->modifiers() != Qt::NoModifier || widget == nullptr ||
      !page_.isVisible() || widget->window() != page_.window() || handles_space(*widget))
    return false;
  if (!key->isAutoRepeat()) act_();
  return true;
}

}  // namespace alltact
