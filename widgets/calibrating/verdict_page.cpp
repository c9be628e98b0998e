#include "widgets/calibrating/verdict_page.h"

#include "widgets/calibrating/verdict_sheet.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/language.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/report_words.h"
#include "widgets/shell/icons.h"
#include "widgets/theme.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kVerdictSymbol = 40;
constexpr int kMinPlotHeight = 110;
constexpr int kTextSpacing = 2;
constexpr std::size_t kShownFindings = 4;  // the others come first in the remarks

}  // namespace

VerdictPage::VerdictPage(CalibrationRun& run, QWidget* parent)
    : StepPage(parent),
      run_(run),
      symbol_(new QLabel),
      grade_(new QLabel),
      findings_(wrapped_text()),
      sentence_(wrapped_text()),
      zones_(wrapped_text()),
      task_(new QPushButton),
      running_(new QProgressBar),
      next_(wrapped_text()),
      face_(new FaceMapPlot),
      remarks_(new QListWidget),
      print_(new QPushButton),
      report_(new QPushButton),
      copy_(new QPushButton),
      figures_(new QWidget),
      errors_(new PressErrorPlot),
      mapping_(new MappingPlot),
      fold_(new QToolButton),
      fold_more_(new QToolButton),
      folded_(new QWidget),
      more_(new MoreDataBox),
      report_state_(wrapped_text()),
      command_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  make_head(*column);
  for (Plot* plot :
       {static_cast<Plot*>(face_), static_cast<Plot*>(errors_), static_cast<Plot*>(mapping_)})
    plot->setMinimumHeight(kMinPlotHeight);
  column->addWidget(face_, 1);
  auto* figures = new QHBoxLayout(figures_);
  figures->setContentsMargins(0, 0, 0, 0);
  figures->addWidget(errors_, 1);
  figures->addWidget(mapping_, 1);
  column->addWidget(figures_, 1);
  make_foot(*column);
  connect(print_, &QPushButton::clicked, this, &VerdictPage::print);
  connect(task_, &QPushButton::clicked, this, &VerdictPage::do_task);
  connect(report_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(run_.report().string())));
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(run_.command_line());
  });
  for (const auto& [one, other] : {std::pair(fold_, fold_more_), std::pair(fold_more_, fold_)})
    connect(one, &QToolButton::toggled, this, [this, other = other](bool is_open) {
      if (is_open) other->setChecked(false);
      show_folds();
    });
  connect(&run_, &CalibrationRun::changed, this, &VerdictPage::show_status);
  say([this] {
    remarks_->setAccessibleName(tr("Remarks"));
    running_->setAccessibleName(tr("Progress of the calibration"));
    print_->setText(tr("&Print…"));
    print_->setShortcut(QKeySequence::Print);  // setText() removes the shortcut
    print_->setToolTip(tr("One sheet to keep beside the finger, on paper or as PDF"));
    report_->setText(tr("&Open the report"));
    copy_->setText(tr("Copy as command &line"));
    command_->setAccessibleName(tr("The same as a command line"));
    mapping_->setAccessibleName(tr("Depth over brightness difference"));
    errors_->setAccessibleName(tr("Error of every press, worst first"));
    shown_.reset();
    show_status();
  });
}

void VerdictPage::make_head(QVBoxLayout& column) {
  auto* head = new QHBoxLayout;
  head->addWidget(symbol_, 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  words->setSpacing(kTextSpacing);
  QFont large = grade_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  grade_->setFont(large);
  grade_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->addWidget(grade_);
  words->addWidget(findings_);
  words->addWidget(sentence_);
  words->addWidget(zones_);
  words->addWidget(next_);
  head->addLayout(words, 1);
  auto* side = new QVBoxLayout;
  side->addWidget(task_);
  side->addWidget(running_);
  side->addStretch();
  head->addLayout(side);
  column.addLayout(head);
}

void VerdictPage::make_foot(QVBoxLayout& column) {
  auto* buttons = new QHBoxLayout;
  for (QToolButton* fold : {fold_, fold_more_}) {
    fold->setCheckable(true);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  buttons->addWidget(print_);
  buttons->addWidget(report_);
  buttons->addWidget(copy_);
  buttons->addWidget(fold_);
  buttons->addWidget(fold_more_);
  buttons->addWidget(report_state_, 1);
  column.addLayout(buttons);
  auto* inside = new QVBoxLayout(folded_);
  inside->setContentsMargins(0, 0, 0, 0);
  remarks_->setWordWrap(true);
  remarks_->setMaximumHeight(110);
  inside->addWidget(remarks_);
  QFont mono(QStringLiteral("monospace"));
  mono.setStyleHint(QFont::Monospace);
  command_->setFont(mono);
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  inside->addWidget(command_);
  column.addWidget(folded_);
  column.addWidget(more_);
}

void VerdictPage::show_folds() {
  const int count = shown_ ? remarks_->count() : 0;
  const bool has_more = more_->finger() != nullptr;
  fold_->setText(tr("Remarks (%1)").arg(count));
  fold_more_->setText(MoreDataBox::tr("What more would bring"));
  fold_more_->setVisible(has_more);
  for (QToolButton* fold : {fold_, fold_more_})
    fold->setArrowType(fold->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  folded_->setVisible(fold_->isChecked());
  more_->setVisible(fold_more_->isChecked() && has_more);
  figures_->setVisible(!fold_->isChecked() && !more_->isVisibleTo(this));
  remarks_->setVisible(shown_ != nullptr);
}

void VerdictPage::print() {
  if (shown_) print_sheet(verdict_sheet(*shown_, run_.command_line(), run_.worth()), *this);
}

StepState VerdictPage::state() const {
  if (run_.state() == CalibrationState::kNone) return StepState::kToDo;
  const auto known = verdict_of(run_);
  const bool is_proven = known && (known->grade == Grade::kGood || known->grade == Grade::kUsable);
  return run_.state() == CalibrationState::kCurrent && is_proven ? StepState::kDone
                                                                 : StepState::kOutdated;
}

VerdictPage::Task VerdictPage::task() const {
  if (run_.state() == CalibrationState::kNone) return Task::kNone;
  if (run_.is_running() || run_.state() == CalibrationState::kStale || !known_) return Task::kAgain;
  if (known_->missing_names.empty()) return Task::kNone;
  const std::string_view worst = known_->missing_names.front();
  if (worst == "basis_stored" || worst == "complete") return Task::kAgain;
  if (worst == "fresh") return Task::kCheck;
  // Scattered light, and an error between good and usable, are measured: no evidence is missing.
  return known_->grade == Grade::kUsable ? Task::kNone : Task::kPresses;
}

const QPushButton* VerdictPage::action_button() const {
  return task() != Task::kNone && task_->isEnabled() ? task_ : nullptr;
}

void VerdictPage::do_task() {
  switch (task()) {
    case Task::kAgain:
      return run_.start();
    case Task::kPresses:
      Q_EMIT presses_requested();
      return;
    case Task::kCheck:
      Q_EMIT check_requested();
      return;
    case Task::kNone:
      return;
  }
}

void VerdictPage::show_task() {
  const Task now = task();
  task_->setVisible(now != Task::kNone);
  task_->setEnabled(now != Task::kAgain || run_.can_start());
  task_->setText(now == Task::kPresses ? tr("Go to the presses")
                 : now == Task::kCheck ? tr("Go to the check")
                                       : tr("&Calibrate again"));
  running_->setVisible(run_.is_running());
  running_->setValue(static_cast<int>(100 * run_.work().fraction()));
}

QString VerdictPage::missing() const {
  return run_.state() == CalibrationState::kNone ? tr("Calibrate first.") : QString();
}

/// Grade, contradictions or missing evidence, and the basis of the verdict; always visible.
void VerdictPage::show_head() {
  known_ = verdict_of(run_);
  const auto& worth = run_.worth();
  const Headline headline = !known_ ? Headline{run_.state() == CalibrationState::kNone
                                                   ? tr("Not calibrated yet")
                                                   : tr("Calibrated; how well is not stored"),
                                               Meaning::kDoubtful}
                                    : headline_of(known_->grade,
                                                  expected_error_mm(*known_).value_or(0.0),
                                                  worth->must_repeat,
                                                  worth->reference);
  symbol_->setPixmap(symbol(meaning_symbol(headline.meaning),
                            meaning_colour(headline.meaning, palette()),
                            kVerdictSymbol,
                            devicePixelRatioF()));
  grade_->setText(headline.text);
  QStringList findings;
  if (known_) {
    const auto all = findings_of(*known_, worth->evidence->contradictions);
    for (std::size_t i = 0; i < std::min(all.size(), kShownFindings); ++i)
      findings << tr("• %1", "an item of a list").arg(window_sentence(all[i]));
    if (all.size() > kShownFindings)
      findings << tr("• And %n more, first of the remarks.",
                     nullptr,
                     static_cast<int>(all.size() - kShownFindings));
  }
  if (run_.state() == CalibrationState::kStale && !(worth && worth->must_repeat))
    findings.prepend(tr("• The presses have changed since: calibrate again."));
  findings_->setText(findings.join(QLatin1Char('\n')));
  findings_->setVisible(!findings.isEmpty());
  QStringList words;
  if (known_) {
    const bool is_vouched = expected_error_mm(*known_).has_value();
    if (!is_vouched && std::isfinite(known_->error_mm) && !worth->must_repeat)
      words << tr("So far ±%1 mm are to be expected.").arg(local_mm(known_->error_mm, 3));
    if (!known_->cause.empty() && !worth->must_repeat) words << window_sentence(known_->cause);
    if (!known_->rests_on.empty())
      words << tr("It rests on: %1.").arg(in_window_language(known_->rests_on));
  }
  sentence_->setText(words.join(QLatin1Char(' ')));
  sentence_->setVisible(!words.isEmpty());
}

void VerdictPage::show_status() {
  show_head();
  show_task();
  more_->set_finger(run_.state() == CalibrationState::kCurrent ? run_.finger() : nullptr);
  report_->setEnabled(!run_.report().empty());
  print_->setEnabled(run_.result() != nullptr);
  copy_->setEnabled(run_.state() != CalibrationState::kNone);
  command_->setVisible(run_.state() != CalibrationState::kNone);
  command_->setText(run_.command_line());
  report_state_->setText(run_.is_writing_report() ? tr("The report is being written.")
                         : run_.report_problem() ? window_sentence(run_.report_problem()->message())
                                                 : QString());
  const QString findings = findings_->text();
  if (run_.result() != shown_ || !shown_ || findings != shown_findings_) {
    shown_ = run_.result();
    shown_findings_ = findings;
    zones_->setVisible(shown_ != nullptr);
    if (shown_)
      zones_->setText(
          tr("By zone of the face: %1.").arg(in_window_language(zone_sentence(shown_->zones))));
    show_next_press();
    show_remarks();
  }
  show_folds();
  Q_EMIT changed();
}

void VerdictPage::show_next_press() {
  next_->setVisible(shown_ != nullptr);
  if (!shown_) return;
  errors_->set_data(press_errors(shown_->calibration));
  mapping_->set_data(mapping_figure(shown_->calibration, shown_->residuals));
  const Calibration& calibration = shown_->calibration;
  FaceMapData data = face_figure(
      FaceQuantity::kCoverage, calibration, shown_->residuals, shown_->finger.face.kind);
  const auto& advice = calibration.next_press;
  if (!advice) {
    next_->setText(tr("Nothing can be said about it with these presses."));
  } else {
    next_->setText(window_sentence(advice->sentence));
    if (!advice->enough) {
      const double r = shown_->inputs.press_set.ball_radius_mm, d = std::min(advice->depth_mm, r);
      data.contacts.push_back({advice->along_mm,
                               advice->across_mm,
                               std::sqrt(d * (2 * r - d)),
                               tr("press here next").toStdString(),
                               true});
    }
  }
  face_->set_data(std::move(data));
}

void VerdictPage::show_remarks() {
  remarks_->clear();
  if (!shown_) return;
  if (known_ && run_.worth()) {
    const auto findings = findings_of(*known_, run_.worth()->evidence->contradictions);
    for (std::size_t i = kShownFindings; i < findings.size(); ++i)
      remarks_->addItem(window_sentence(findings[i]));
  }
  const Calibration& calibration = shown_->calibration;
  const auto add = [this](const Message& text) { remarks_->addItem(window_sentence(text)); };
  for (const Message& sign : shown_->fault_signs) add(sign);
  for (const Message& warning : shown_->about_settings) add(warning);
  for (const Message& warning : shown_->warnings) add(warning);
  for (const Message& reason : calibration.left_out) add(reason);
  for (const Message& remark : calibration.remarks)
    if (!calibration.next_press || remark != calibration.next_press->sentence) add(remark);
}

void VerdictPage::changeEvent(QEvent* event) {
  StepPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_status();
}

}  // namespace alltact
