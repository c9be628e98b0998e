#include "widgets/calibrating/verdict_page.h"

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

QString grade_text(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return VerdictPage::tr("Good");
    case Grade::kUsable:
      return VerdictPage::tr("Usable for contact and its place");
    case Grade::kUnproven:
      return VerdictPage::tr("Unproven");
    case Grade::kUnfit:
      break;
  }
  return VerdictPage::tr("Not fit to measure with");
}

Meaning meaning_of(Grade grade) {
  if (grade == Grade::kGood) return Meaning::kGood;
  return grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful;
}

QString symbol_name(Meaning meaning) {
  return meaning == Meaning::kGood       ? QStringLiteral("good")
         : meaning == Meaning::kDoubtful ? QStringLiteral("doubtful")
                                         : QStringLiteral("bad");
}

/// Of the stored figures where the whole calibration is not in memory.
std::optional<Verdict> verdict_of(const CalibrationRun& run) {
  if (run.result()) return run.result()->verdict;
  if (!run.finger() || !run.finger()->finger.mapping_record) return std::nullopt;
  const MappingRecord& record = *run.finger()->finger.mapping_record;
  return verdict({record.residual_mm,
                  record.held_out_mm,
                  record.spread_mm,
                  static_cast<int>(record.presses.size()),
                  record.pixel_mm});
}

}  // namespace

VerdictPage::VerdictPage(CalibrationRun& run, QWidget* parent)
    : StepPage(parent),
      run_(run),
      symbol_(new QLabel),
      grade_(new QLabel),
      sentence_(wrapped_text()),
      zones_(wrapped_text()),
      next_group_(new QGroupBox),
      remarks_group_(new QGroupBox),
      next_(wrapped_text()),
      face_(new FaceMapPlot),
      remarks_(new QListWidget),
      more_(new MoreBox),
      report_(new QPushButton),
      copy_(new QPushButton),
      report_state_(wrapped_text()),
      command_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
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
  column->addLayout(head);
  auto* middle = new QHBoxLayout;
  auto* next = new QVBoxLayout(next_group_);
  next->addWidget(next_);
  next->addWidget(face_, 1);
  middle->addWidget(next_group_, 3);
  auto* remarks = new QVBoxLayout(remarks_group_);
  remarks_->setWordWrap(true);
  remarks->addWidget(remarks_);
  auto* beside = new QVBoxLayout;
  beside->addWidget(remarks_group_, 1);
  beside->addWidget(more_, 1);
  middle->addLayout(beside, 2);
  column->addLayout(middle, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(report_);
  buttons->addWidget(copy_);
  buttons->addWidget(report_state_, 1);
  column->addLayout(buttons);
  QFont mono(QStringLiteral("monospace"));
  mono.setStyleHint(QFont::Monospace);
  command_->setFont(mono);
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  column->addWidget(command_);
  connect(report_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(run_.report().string())));
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(run_.command_line());
  });
  connect(&run_, &CalibrationRun::changed, this, &VerdictPage::show_status);
  say([this] {
    next_group_->setTitle(tr("What to press next"));
    remarks_group_->setTitle(tr("Remarks"));
    remarks_->setAccessibleName(tr("Remarks"));
    report_->setText(tr("&Open the report"));
    copy_->setText(tr("Copy as command &line"));
    command_->setAccessibleName(tr("The same as a command line"));
    shown_.reset();
    show_status();
  });
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
    words += QLatin1Char(' ') + tr("The presses have changed since: calibrate again.");
  sentence_->setText(words);
  more_->set_finger(run_.state() == CalibrationState::kCurrent ? run_.finger() : nullptr);
  report_->setEnabled(!run_.report().empty());
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
  Q_EMIT changed();
}

void VerdictPage::show_next_press() {
  next_group_->setVisible(shown_ != nullptr);
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
  remarks_group_->setVisible(shown_ != nullptr);
  if (!shown_) return;
  const Calibration& calibration = shown_->calibration;
  const auto add = [this](const Message& text) { remarks_->addItem(window_sentence(text)); };
  for (const Message& sign : shown_->fault_signs) add(sign);
  for (const Message& warning : shown_->about_settings) add(warning);
  for (const Message& warning : shown_->warnings) add(warning);
  for (const Message& reason : calibration.left_out) add(reason);
  for (const Message& remark : calibration.remarks)
    if (!calibration.next_press || remark != calibration.next_press->sentence) add(remark);
  if (remarks_->count() == 0) remarks_->addItem(tr("None."));
}

void VerdictPage::changeEvent(QEvent* event) {
  StepPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_status();
}

}  // namespace alltact
