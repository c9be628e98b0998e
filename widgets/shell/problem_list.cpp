#include "widgets/shell/problem_list.h"

#include "widgets/accessible.h"
#include "widgets/language.h"
#include "widgets/shell/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace alltact {
namespace {

constexpr int kProblemSymbol = 20;

QString symbol_of(Meaning meaning) {
  switch (meaning) {
    case Meaning::kGood:
      return QStringLiteral("good");
    case Meaning::kDoubtful:
      return QStringLiteral("doubtful");
    case Meaning::kBad:
      break;
  }
  return QStringLiteral("bad");
}

}  // namespace

Problem Problem::of(const Error& error, Meaning meaning) {
  Problem problem;
  problem.meaning = meaning;
  problem.told = error;
  problem.what = window_sentence(en::at(error.where, error.what));
  if (!error.advice.empty())
    problem.advice =
        ProblemList::tr("Try: %1").arg(in_window_language(en::say("{}.", error.advice)));
  return problem;
}

bool Problem::says_the_same(const Problem& other) const {
  return meaning == other.meaning && what == other.what && advice == other.advice &&
         action == other.action;
}

ProblemList::ProblemList(QWidget* parent) : Translated(parent), rows_(new QVBoxLayout(this)) {
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(4);
  set_accessible_role(*this, QAccessible::List);
  hide();
  say([this] {
    setAccessibleName(tr("Problems"));
    word_anew();
  });
}

void ProblemList::set_problems(std::vector<Problem> problems) {
  const bool is_same = std::equal(
      problems.begin(), problems.end(), problems_.begin(), problems_.end(), [](auto& a, auto& b) {
        return a.says_the_same(b);
      });
  problems_ = std::move(problems);
  if (!is_same) rebuild();
}

void ProblemList::word_anew() {
  for (Problem& problem : problems_)
    if (problem.told) {
      Problem anew = Problem::of(*problem.told, problem.meaning);
      problem.what = std::move(anew.what);
      problem.advice = std::move(anew.advice);
    }
  rebuild();
}

void ProblemList::rebuild() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (const Problem& problem : problems_) rows_->addWidget(make_row(problem));
  setVisible(!problems_.empty());
  if (problems_.empty()) return;
  QAccessibleEvent event(rows_->itemAt(0)->widget(), QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QWidget* ProblemList::make_row(const Problem& problem) {
  auto* row = new QFrame;
  row->setObjectName(QStringLiteral("problem"));
  row->setFocusPolicy(Qt::TabFocus);
  set_accessible_role(*row, QAccessible::AlertMessage);
  const QString word = problem.meaning == Meaning::kBad        ? tr("Problem")
                       : problem.meaning == Meaning::kDoubtful ? tr("Note")
                                                               : tr("Good");
  row->setAccessibleName(word + QStringLiteral(": ") + problem.what + QLatin1Char(' ') +
                         problem.advice);
  const QColor colour = meaning_colour(problem.meaning, palette());
  row->setStyleSheet(QStringLiteral("#problem { border: 1px solid %1; border-left: 5px solid %1; "
                                    "background: %2; } #problem:focus { border: 2px solid %3; }")
                         .arg(colour.name(),
                              palette().color(QPalette::Base).name(),
                              palette().color(QPalette::Highlight).name()));
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(10, 6, 10, 6);
  auto* picture = new QLabel;
  picture->setPixmap(
      symbol(symbol_of(problem.meaning), colour, kProblemSymbol, devicePixelRatioF()));
  picture->setAccessibleName(word);
  layout->addWidget(picture, 0, Qt::AlignVCenter);
  auto* text = new QLabel(
      QStringLiteral("<b>%1:</b> %2 %3")
          .arg(word.toHtmlEscaped(), problem.what.toHtmlEscaped(), problem.advice.toHtmlEscaped()));
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(text, 1);
  if (!problem.action.isEmpty()) {
    auto* button = new QPushButton(problem.action);
    connect(button, &QPushButton::clicked, this, problem.on_action);
    layout->addWidget(button, 0, Qt::AlignVCenter);
  }
  return row;
}

void ProblemList::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace alltact
