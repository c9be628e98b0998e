#include "widgets/pages/accuracy_page.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/study/study_front.h"
#include "widgets/language.h"
#include "widgets/tip_of_text.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolTip>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

constexpr double kLargerWords = 1.25;
constexpr int kRates[] = {10, 30, 60, 100};
constexpr int kMinRate = 1, kMaxRate = 1000;
constexpr double kErrorStepMm = 0.005;

QLabel* wrapping_words() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  return label;
}

void enlarge(QWidget& widget, double times) {
  QFont font = widget.font();
  font.setPointSizeF(times * font.pointSizeF());
  widget.setFont(font);
}

}  // namespace

AccuracyPage::AccuracyPage(LiveSession& session,
                           QUndoStack& undo,
                           std::string program_version,
                           QWidget* parent)
    : Page("accuracy", parent),
      session_(session),
      run_(undo, std::move(program_version)),
      pages_(new QStackedWidget),
      first_words_(wrapping_words()),
      first_reason_(wrapping_words()),
      measure_(new QPushButton),
      rate_label_(new QLabel),
      error_label_(new QLabel),
      rate_(new QComboBox),
      error_(new NumberField),
      answer_(wrapping_words()),
      figures_(wrapping_words()),
      note_(wrapping_words()),
      use_(new QPushButton),
      as_calibrated_(new QPushButton),
      tabs_(new QTabWidget),
      plot_(new AccuracyPlot),
      table_(new AccuracyTable),
      sides_(new SettingsComparison(session)),
      more_(new QPushButton),
      copy_(new QPushButton),
      command_(new QLineEdit),
      standing_(wrapping_words()),
      progress_(new QWidget),
      bar_(new QProgressBar),
      left_(new QLabel),
      stop_(new QPushButton) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* running = new QHBoxLayout(progress_);
  running->setContentsMargins(0, 0, 0, 0);
  running->addWidget(bar_, 1);
  running->addWidget(left_);
  running->addWidget(stop_);
  column->addWidget(progress_);
  pages_->addWidget(make_first());
  pages_->addWidget(make_measured());
  column->addWidget(pages_, 1);
  connect_parts();
  say([this] { name_parts(); });
  update_question();
}

QWidget* AccuracyPage::make_first() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(60, 0, 60, 0);
  column->addStretch();
  enlarge(*first_words_, kLargerWords);
  first_words_->setAlignment(Qt::AlignCenter);
  column->addWidget(first_words_);
  column->addSpacing(16);
  enlarge(*measure_, kLargerWords);
  measure_->setMinimumHeight(64);
  column->addWidget(measure_);
  first_reason_->setAlignment(Qt::AlignCenter);
  column->addWidget(first_reason_);
  column->addStretch();
  return page;
}

QWidget* AccuracyPage::make_measured() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(make_questions());
  column->addLayout(make_answer());
  tabs_->addTab(plot_, {});
  tabs_->addTab(table_, {});
  tabs_->addTab(sides_, {});
  tabs_->setDocumentMode(true);
  column->addWidget(tabs_, 1);
  auto* line = new QHBoxLayout;
  command_->setReadOnly(true);
  show_text_as_tip(*command_);
  QFont mono(QStringLiteral("monospace"));
  mono.setStyleHint(QFont::Monospace);
  command_->setFont(mono);
  line->addWidget(command_, 1);
  line->addWidget(copy_);
  line->addWidget(more_);
  column->addLayout(line);
  return page;
}

QLayout* AccuracyPage::make_questions() {
  auto* line = new QHBoxLayout;
  rate_->setEditable(true);
  rate_->setInsertPolicy(QComboBox::NoInsert);
  for (const int rate : kRates) rate_->addItem(QString::number(rate));
  rate_->setCurrentText(QString::number(question_.frames_per_s));
  rate_label_->setBuddy(rate_);
  error_->setRange(0, 10);
  error_->set_shown_decimals(3);
  error_->setSingleStep(kErrorStepMm);
  error_label_->setBuddy(error_);
  for (QWidget* widget : {static_cast<QWidget*>(rate_label_),
                          static_cast<QWidget*>(rate_),
                          static_cast<QWidget*>(error_label_),
                          static_cast<QWidget*>(error_)}) {
    line->addWidget(widget);
    if (widget == rate_) line->addSpacing(20);
  }
  line->addStretch();
  return line;
}

QLayout* AccuracyPage::make_answer() {
  auto* line = new QHBoxLayout;
  auto* words = new QVBoxLayout;
  words->setSpacing(1);
  QFont bold = answer_->font();
  bold.setBold(true);
  answer_->setFont(bold);
  enlarge(*answer_, kLargerWords);
  for (QLabel* label : {answer_, figures_, note_, standing_}) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(label);
  }
  line->addLayout(words, 1);
  auto* buttons = new QVBoxLayout;
  use_->setMinimumHeight(36);
  buttons->addWidget(use_);
  buttons->addWidget(as_calibrated_);
  buttons->addStretch();
  line->addLayout(buttons);
  return line;
}

void AccuracyPage::connect_parts() {
  connect(&session_, &LiveSession::status_ready, this, &AccuracyPage::follow);
  connect(&run_, &FingerStudyRun::changed, this, &AccuracyPage::show_run);
  connect(rate_, &QComboBox::currentTextChanged, this, &AccuracyPage::update_question);
  connect(rate_->lineEdit(), &QLineEdit::editingFinished, this, [this] {
    finished_rate_ = question_.frames_per_s;
  });
  connect(error_, &NumberField::valueChanged, this, &AccuracyPage::update_question);
  connect(plot_, &AccuracyPlot::point_picked, this, &AccuracyPage::pick);
  connect(table_, &AccuracyTable::point_picked, this, &AccuracyPage::pick);
  connect(plot_, &AccuracyPlot::point_activated, this, &AccuracyPage::use);
  connect(table_, &AccuracyTable::point_activated, this, &AccuracyPage::use);
  connect(plot_, &AccuracyPlot::pick_cleared, this, &AccuracyPage::update_question);
  connect(use_, &QPushButton::clicked, this, &AccuracyPage::use);
  connect(as_calibrated_, &QPushButton::clicked, this, [this] { run_.use(0); });
  connect(measure_, &QPushButton::clicked, this, [this] { run_.start(StudyExtent::kQuick); });
  connect(more_, &QPushButton::clicked, this, [this] {
    const auto& study = run_.study();
    const bool is_good = study && study->is_of_finger_now && study->is_of_this_computer;
    run_.start(is_good && study->has_all_single ? StudyExtent::kPairs : StudyExtent::kQuick);
  });
  connect(stop_, &QPushButton::clicked, this, [this] { run_.stop(); });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(command_line());
  });
}

void AccuracyPage::name_parts() {
  first_words_->setText(
      tr("How fast must it be, and what error may it have? What settings cost in time and bring in "
         "accuracy is measured once on this finger's own pictures; then one answer stands here."));
  measure_->setText(tr("&Measure what settings cost on this finger (about 12 s)"));
  rate_label_->setText(tr("How many pictures per &second?"));
  rate_->setAccessibleName(tr("How many pictures per second?"));
  error_label_->setText(tr("What er&ror may it have?"));
  error_->setAccessibleName(tr("What error may it have?"));
  error_->setToolTip(tr("Of depth, where 95 % of all points lie within."));
  error_->setSuffix(tr(" mm"));
  error_->setSpecialValueText(tr("as small as fits"));
  as_calibrated_->setText(tr("As cali&brated again"));
  tabs_->setTabText(0, tr("Figure"));
  tabs_->setTabText(1, tr("Table"));
  tabs_->setTabText(2, tr("Live, side by side"));
  tabs_->tabBar()->setAccessibleName(tr("Figure, table or the live picture with two settings"));
  copy_->setText(tr("Copy &command"));
  command_->setAccessibleName(tr("The same as a command line"));
  bar_->setAccessibleName(tr("Progress of measuring"));
  stop_->setText(tr("Sto&p"));
  stop_->setToolTip(tr("What was measured is kept; measuring goes on there another time."));
  shown_.reset();
  show_run();
}

void AccuracyPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || !plot_) return;
  plot_->update();
}

void AccuracyPage::follow() {
  const auto& folder = session_.status().finger.folder;
  if (folder == folder_) return;
  folder_ = folder;
  picked_.reset();
  run_.open(folder_);
}

void AccuracyPage::update_question() {
  const auto typed =
      parse_typed_number(rate_->currentText().toStdString(), {window_decimal_mark(), {}});
  const auto is_rate = [](double rate) {
    return rate == std::round(rate) && rate >= kMinRate && rate <= kMaxRate;
  };
  question_.frames_per_s = typed && is_rate(*typed) ? static_cast<int>(*typed) : finished_rate_;
  const QString refused =
      !typed ? window_sentence(typed.error().what)
      : is_rate(*typed)
          ? QString()
          : window_sentence(en::say("must be a whole number from {} to {}", kMinRate, kMaxRate));
  rate_->setToolTip(refused);
  rate_->setAccessibleDescription(refused);
  if (!refused.isEmpty() && rate_->isVisible())
    QToolTip::showText(rate_->mapToGlobal(QPoint(0, rate_->height())), refused, rate_);
  question_.error_mm = error_->value() > 0 ? std::optional(error_->value()) : std::nullopt;
  picked_.reset();
  plot_->set_budget(question_.frames_per_s);
  show_answer();
}

void AccuracyPage::pick(std::size_t point) {
  if (point >= rows_.size()) return;
  picked_ = rows_[point];
  show_answer();
}

void AccuracyPage::use() {
  if (const auto row = answer_row()) run_.use(*row);
}

std::optional<std::size_t> AccuracyPage::answer_row() const {
  if (picked_) return picked_;
  return study_answer_ ? std::optional(study_answer_->row) : std::nullopt;
}

void AccuracyPage::add_problems(std::vector<Problem>& problems) {
  if (isVisible() && run_.problem()) problems.push_back(Problem::of(*run_.problem()));
}

}  // namespace alltact
