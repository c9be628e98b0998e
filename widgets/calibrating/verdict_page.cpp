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

namespace alltact {
namespace {

constexpr int kVerdictSymbol = 40;
constexpr int kLeastPlotHeight = 110;
constexpr int kBetweenWords = 2;

}  // namespace

VerdictPage::VerdictPage(CalibrationRun& run, QWidget* parent)
    : StepPage(parent),
      run_(run),
      symbol_(new QLabel),
      grade_(new QLabel),
      sentence_(wrapped_text()),
      zones_(wrapped_text()),
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
      more_(new MoreBox),
      report_state_(wrapped_text()),
      command_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  make_head(*column);
  for (Plot* plot :
       {static_cast<Plot*>(face_), static_cast<Plot*>(errors_), static_cast<Plot*>(mapping_)})
    plot->setMinimumHeight(kLeastPlotHeight);
  column->addWidget(face_, 1);
  auto* figures = new QHBoxLayout(figures_);
  figures->setContentsMargins(0, 0, 0, 0);
  figures->addWidget(errors_, 1);
  figures->addWidget(mapping_, 1);
  column->addWidget(figures_, 1);
  make_foot(*column);
  connect(print_, &QPushButton::clicked, this, &VerdictPage::print);
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
    print_->setText(tr("&Print…"));
    print_->setShortcut(QKeySequence::Print);  // a new text takes it away
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
  words->setSpacing(kBetweenWords);
  QFont large = grade_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  grade_->setFont(large);
  grade_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->addWidget(grade_);
  words->addWidget(sentence_);
  words->addWidget(zones_);
  words->addWidget(next_);
  head->addLayout(words, 1);
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
  fold_more_->setText(MoreBox::tr("What more would bring"));
  fold_more_->setVisible(has_more);
  for (QToolButton* fold : {fold_, fold_more_})
    fold->setArrowType(fold->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  folded_->setVisible(fold_->isChecked());
  more_->setVisible(fold_more_->isChecked() && has_more);
  figures_->setVisible(!fold_->isChecked() && !more_->isVisibleTo(this));
  remarks_->setVisible(shown_ != nullptr);
}

void VerdictPage::print() {
  if (shown_) print_sheet(verdict_sheet(*shown_, run_.command_line()), *this);
}

StepState VerdictPage::state() const {
  if (run_.state() == CalibrationState::kStale) return StepState::kLookAgain;
  return run_.state() == CalibrationState::kCurrent ? StepState::kDone : StepState::kToDo;
}

QString VerdictPage::missing() const {
  return run_.state() == CalibrationState::kNone ? tr("Calibrate first.") : QString();
}

void VerdictPage::show_status() {
  const auto known = verdict_of(run_);
  const Meaning meaning = known ? meaning_of(known->grade) : Meaning::kDoubtful;
  symbol_->setPixmap(symbol(symbol_name(meaning),
                            meaning_colour(meaning, palette()),
                            kVerdictSymbol,
                            devicePixelRatioF()));
  grade_->setText(known ? grade_text(known->grade) : tr("Not calibrated yet"));
  QString words;
  if (known) words = window_sentence(known->reason);
  if (run_.state() == CalibrationState::kStale)
    words += QLatin1Char(' ') +
             (run_.has_other_finger()
                  ? tr("The finger's sizes or markers have changed since: calibrate again.")
                  : tr("The presses have changed since: calibrate again."));
  sentence_->setText(words);
  more_->set_finger(run_.state() == CalibrationState::kCurrent ? run_.finger() : nullptr);
  report_->setEnabled(!run_.report().empty());
  print_->setEnabled(run_.result() != nullptr);
  copy_->setEnabled(run_.state() != CalibrationState::kNone);
  command_->setVisible(run_.state() != CalibrationState::kNone);
  command_->setText(run_.command_line());
  report_state_->setText(run_.is_writing_report() ? tr("The report is being written.")
                         : run_.report_problem() ? window_sentence(run_.report_problem()->message())
                                                 : QString());
  if (run_.result() != shown_ || !shown_) {
    shown_ = run_.result();
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
      const double r = shown_->inputs.said.ball_radius_mm, d = std::min(advice->depth_mm, r);
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
