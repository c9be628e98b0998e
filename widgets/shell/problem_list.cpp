#include "widgets/shell/problem_list.h"

#include "core/live/source_runner.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kProblemSymbol = 18, kNoticeHeight_px = 32;
constexpr int kBetweenAges_ms = 20000;

qint64 now_ms() { return monotonic_ns() / 1000000; }

QString without_numbers(QString text) {
  static const QRegularExpression numbers(QStringLiteral("[0-9][0-9.,]*"));
  return text.remove(numbers);
}

/// Compares without numbers: counts and figures of a lasting problem grow.
bool is_same_problem(const Problem& a, const Problem& b) {
  return a.meaning == b.meaning && without_numbers(a.what) == without_numbers(b.what);
}

}  // namespace

Problem Problem::of(const Error& error, Meaning meaning) {
  Problem problem;
  problem.meaning = meaning;
  problem.cause = error;
  problem.what = window_sentence(en::at(error.where, error.what));
  if (!error.advice.empty())
    problem.advice =
        ProblemList::tr("Try: %1").arg(in_window_language(en::say("{}.", error.advice)));
  return problem;
}

bool Problem::has_same_text(const Problem& other) const {
  return meaning == other.meaning && what == other.what && advice == other.advice &&
         action == other.action;
}

ProblemList::ProblemList(QWidget* parent)
    : Translated(parent), sheet_(new QWidget), rows_(new QVBoxLayout(sheet_)) {
  without_margins(new QVBoxLayout(this))->addWidget(sheet_, 0, Qt::AlignTop);
  setMinimumHeight(kNoticeHeight_px);
  sheet_->setAutoFillBackground(true);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(4);
  set_accessible_role(*this, QAccessible::List);
  connect(&clock_, &QTimer::timeout, this, &ProblemList::show_ages);
  clock_.setInterval(kBetweenAges_ms);
  say([this] {
    setAccessibleName(tr("Problems"));
    retranslate();
  });
}

void ProblemList::set_problems(std::vector<Problem> problems) {
  std::vector<ListedProblem> now, before;
  const qint64 time_ms = now_ms();
  bool is_same = problems.size() == listed_.size();
  for (Problem& problem : problems) {
    const auto old = std::find_if(listed_.begin(), listed_.end(), [&](const ListedProblem& listed) {
      return is_same_problem(listed.problem, problem);
    });
    is_same = is_same && old != listed_.end() && old->problem.has_same_text(problem);
    if (old == listed_.end())
      now.push_back({std::move(problem), time_ms, false});
    else
      before.push_back({std::move(problem), old->since_ms, old->is_dismissed});
  }
  now.insert(now.end(), std::make_move_iterator(before.begin()),
             std::make_move_iterator(before.end()));
  std::stable_sort(now.begin(), now.end(), [](const ListedProblem& a, const ListedProblem& b) {
    return a.since_ms > b.since_ms;
  });
  listed_ = std::move(now);
  if (!is_same) rebuild();
}

std::vector<const ProblemList::ListedProblem*> ProblemList::shown() const {
  std::vector<const ListedProblem*> shown;
  for (const ListedProblem& listed : listed_)
    if (!listed.is_dismissed) shown.push_back(&listed);
  return shown;
}

std::vector<Problem> ProblemList::problems() const {
  std::vector<Problem> problems;
  for (const ListedProblem* listed : shown()) problems.push_back(listed->problem);
  return problems;
}

void ProblemList::dismiss(const QString& what) {
  for (ListedProblem& listed : listed_)
    if (listed.problem.what == what) listed.is_dismissed = true;
  rebuild();
}

void ProblemList::retranslate() {
  for (ListedProblem& listed : listed_)
    if (listed.problem.cause) {
      Problem anew = Problem::of(*listed.problem.cause, listed.problem.meaning);
      listed.problem.what = std::move(anew.what);
      listed.problem.advice = std::move(anew.advice);
    }
  rebuild();
}

void ProblemList::rebuild() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  ages_.clear();
  line_ = nullptr;
  fold_ = nullptr;
  const auto all = shown();
  is_unfolded_ = is_in_full_ || (is_unfolded_ && !all.empty());
  for (std::size_t i = 0; i < all.size() && (i == 0 || is_unfolded_); ++i)
    rows_->addWidget(make_row(*all[i], i == 0));
  sheet_->setVisible(!all.empty());
  arrange_sheet();
  all.empty() ? clock_.stop() : clock_.start();
  Q_EMIT filled(!all.empty());
  if (all.empty()) return;
  show_ages();
  show_fold();
  QAccessibleEvent event(rows_->itemAt(0)->widget(), QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QWidget* ProblemList::make_row(const ListedProblem& listed, bool is_first) {
  const Problem& problem = listed.problem;
  auto* row = new QFrame;
  row->setObjectName(QStringLiteral("problem"));
  row->setFocusPolicy(Qt::TabFocus);
  set_accessible_role(*row, QAccessible::AlertMessage);
  const QString word = problem.meaning == Meaning::kBad        ? tr("Problem")
                       : problem.meaning == Meaning::kDoubtful ? tr("Note")
                                                               : tr("Good");
  row->setAccessibleName(labelled(word, problem.what) + QLatin1Char(' ') + problem.advice);
  const QColor colour = meaning_colour(problem.meaning, palette());
  row->setStyleSheet(QStringLiteral("#problem { border: 1px solid %1; border-left: 5px solid %1; "
                                    "background: %2; } #problem:focus { border: 2px solid %3; }")
                         .arg(colour.name(), palette().color(QPalette::Base).name(),
                              palette().color(QPalette::Highlight).name()));
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(10, 3, 6, 3);
  auto* symbol_label = new QLabel;
  symbol_label->setPixmap(
      symbol(meaning_symbol(problem.meaning), colour, kProblemSymbol, devicePixelRatioF()));
  symbol_label->setAccessibleName(word);
  layout->addWidget(symbol_label, 0, Qt::AlignVCenter);
  const QString head = labelled(word, {}).trimmed();
  const QString sentences = problem.what + QLatin1Char(' ') + problem.advice;
  if (is_unfolded_) {
    auto* text = new QLabel(
        QStringLiteral("<b>%1</b> %2").arg(head.toHtmlEscaped(), sentences.toHtmlEscaped()));
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(text, 1);
  } else {
    line_ = new ElidedLabel;
    line_->set_text(head + QLatin1Char(' ') + sentences, static_cast<int>(head.size()));
    layout->addWidget(line_, 1);
  }
  add_buttons(listed, is_first, *layout);
  return row;
}

void ProblemList::add_buttons(const ListedProblem& listed, bool is_first, QHBoxLayout& layout) {
  auto* age = new QLabel;
  age->setForegroundRole(QPalette::PlaceholderText);
  ages_.emplace_back(age, listed.since_ms);
  layout.addWidget(age, 0, Qt::AlignVCenter);
  if (!listed.problem.action.isEmpty()) {
    auto* button = new QPushButton(listed.problem.action);
    button->setToolTip(tr("Does what the message advises"));
    connect(button, &QPushButton::clicked, this, listed.problem.on_action);
    layout.addWidget(button, 0, Qt::AlignVCenter);
  }
  if (is_first && !is_in_full_) {
    fold_ = new QToolButton;
    fold_->setAutoRaise(true);
    fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold_->setArrowType(is_unfolded_ ? Qt::UpArrow : Qt::DownArrow);
    connect(fold_, &QToolButton::clicked, this, [this] {
      is_unfolded_ = !is_unfolded_;
      rebuild();
      if (fold_->isVisible()) fold_->setFocus();
    });
    layout.addWidget(fold_, 0, Qt::AlignVCenter);
  }
  auto* away = new QToolButton;
  away->setAutoRaise(true);
  away->setText(QString(QChar(0x00d7)));
  away->setToolTip(tr("Dismiss until it happens again"));
  away->setAccessibleName(tr("Dismiss: %1").arg(listed.problem.what));
  connect(away, &QToolButton::clicked, this, [this, what = listed.problem.what] { dismiss(what); });
  layout.addWidget(away, 0, Qt::AlignVCenter);
}

QString ProblemList::age_text(qint64 since_ms) const {
  const auto minutes = static_cast<int>((now_ms() - since_ms) / 60000);
  if (minutes < 1) return tr("now");
  if (minutes < 60) return tr("%n min ago", nullptr, minutes);
  return tr("%n h ago", nullptr, minutes / 60);
}

void ProblemList::show_ages() {
  for (const auto& [label, since_ms] : ages_) label->setText(age_text(since_ms));
}

void ProblemList::show_fold() {
  if (fold_ == nullptr) return;
  const int others = static_cast<int>(shown().size()) - 1;
  fold_->setText(is_unfolded_ || others == 0 ? QString() : tr("%n more", nullptr, others));
  const QString name = is_unfolded_ ? tr("Show only the newest") : tr("Show all in full");
  fold_->setToolTip(name);
  fold_->setAccessibleName(name);
  fold_->setVisible(is_unfolded_ || others > 0 || (line_ != nullptr && line_->is_elided()));
}

void ProblemList::show_in_full() {
  is_in_full_ = true;
  rebuild();
}

void ProblemList::arrange_sheet() {
  const bool is_over = is_unfolded_ && !is_in_full_ && window() != this;
  if (!is_over) {
    if (sheet_->parentWidget() == this) return;
    static_cast<QVBoxLayout*>(layout())->addWidget(sheet_, 0, Qt::AlignTop);
    sheet_->setVisible(rows_->count() > 0);
    return;
  }
  if (sheet_->parentWidget() != window()) {
    layout()->removeWidget(sheet_);
    sheet_->setParent(window());
  }
  sheet_->setGeometry({mapTo(window(), QPoint()),
                       QSize(width(), std::max(height(), rows_->totalHeightForWidth(width())))});
  sheet_->setVisible(isVisible() && rows_->count() > 0);
  sheet_->raise();
}

bool ProblemList::event(QEvent* event) {
  const bool is_handled = Translated::event(event);
  switch (event->type()) {
    case QEvent::Resize:
      show_fold();
      [[fallthrough]];
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
      arrange_sheet();
      break;
    default:
      break;
  }
  return is_handled;
}

void ProblemList::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace alltact
