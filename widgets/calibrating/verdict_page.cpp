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
      fold_(new QToolButton),
      folded_(new QWidget),
      more_(new MoreBox),
      report_state_(wrapped_text()),
      command_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  make_head(*column);
  column->addWidget(next_);
  auto* middle = new QHBoxLayout;
  middle->addWidget(face_, 3);
  middle->addWidget(more_, 2);
  column->addLayout(middle, 1);
  make_foot(*column);
  connect(print_, &QPushButton::clicked, this, &VerdictPage::print);
  connect(report_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(run_.report().string())));
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(run_.command_line());
  });
  connect(fold_, &QToolButton::toggled, this, &VerdictPage::show_fold);
  connect(&run_, &CalibrationRun::changed, this, &VerdictPage::show_status);
  say([this] {
    remarks_->setAccessibleName(tr("Remarks"));
    print_->setText(tr("&Print…"));
    print_->setShortcut(QKeySequence::Print);  // a new text takes it away
    print_->setToolTip(tr("One sheet to keep beside the finger, on paper or as PDF"));
    report_->setText(tr("&Open the report"));
    copy_->setText(tr("Copy as command &line"));
    command_->setAccessibleName(tr("The same as a command line"));
    shown_.reset();
    show_status();
  });
}

void VerdictPage::make_head(QVBoxLayout& column) {
  auto* head = new QHBoxLayout;
  head->addWidget(symbol_, 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  QFont large = grade_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  grade_->setFont(large);
  grade_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->addWidget(grade_);
  words->addWidget(sentence_);
  words->addWidget(zones_);
  head->addLayout(words, 1);
  column.addLayout(head);
}

void VerdictPage::make_foot(QVBoxLayout& column) {
  auto* buttons = new QHBoxLayout;
  fold_->setCheckable(true);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  buttons->addWidget(print_);
  buttons->addWidget(report_);
  buttons->addWidget(copy_);
  buttons->addWidget(fold_);
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
}

void VerdictPage::show_fold() {
  const int count = shown_ ? remarks_->count() : 0;
  fold_->setText(tr("Remarks (%1)").arg(count));
  fold_->setArrowType(fold_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  folded_->setVisible(fold_->isChecked());
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
  show_fold();
  Q_EMIT changed();
}

void VerdictPage::show_next_press() {
  next_->setVisible(shown_ != nullptr);
  face_->setVisible(shown_ != nullptr);
  if (!shown_) return;
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
