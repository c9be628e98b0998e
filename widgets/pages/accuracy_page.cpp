#include "widgets/pages/accuracy_page.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/study/recommended_settings.h"
#include "widgets/language.h"
#include "widgets/undo_step.h"
#include "widgets/verdict_text.h"
#include "widgets/widget_base.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kLargerWords = 1.25;
constexpr int kRates[] = {10, 30, 60, 100};
constexpr int kMinRate = 1, kMaxRate = 1000;
constexpr double kErrorStepMm = 0.005;

void enlarge(QWidget& widget, double times) {
  QFont font = widget.font();
  font.setPointSizeF(times * font.pointSizeF());
  widget.setFont(font);
}

}  // namespace

AccuracyPage::AccuracyPage(LiveSession& session, QUndoStack& undo, std::string program_version,
                           QWidget* parent)
    : Page("accuracy", parent),
      session_(session),
      run_(undo, std::move(program_version)),
      pages_(new QStackedWidget),
      first_words_(wrapped_label()),
      first_reason_(new ReservedText),
      measure_(new QPushButton),
      rate_label_(new QLabel),
      error_label_(new QLabel),
      rate_(new QComboBox),
      error_(new NumberField),
      answer_(wrapped_label()),
      figures_(wrapped_label()),
      note_(wrapped_label()),
      use_(new QPushButton),
      as_calibrated_(new QPushButton),
      tabs_(new QTabWidget),
      plot_(new AccuracyPlot),
      table_(new AccuracyTable),
      sides_(new SettingsComparison(session)),
      more_(new QPushButton),
      copy_(new QPushButton),
      command_(new QLineEdit),
      standing_(new ReservedText),
      progress_(new QWidget),
      bar_(new QProgressBar),
      left_(new QLabel),
      stop_(new QPushButton) {
  auto* column = without_margins(new QVBoxLayout(this));
  auto* running = without_margins(new QHBoxLayout(progress_));
  running->addWidget(bar_, 1);
  running->addWidget(left_);
  running->addWidget(stop_);
  for (QWidget* shown : std::initializer_list<QWidget*>{progress_, as_calibrated_, more_})
    reserve_room(*shown);
  pages_->addWidget(make_first());
  pages_->addWidget(make_measured());
  column->addWidget(pages_, 1);
  column->addWidget(progress_);
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
  auto* column = without_margins(new QVBoxLayout(page));
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
  for (QWidget* widget :
       std::initializer_list<QWidget*>{rate_label_, rate_, error_label_, error_}) {
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
  connect(rate_->lineEdit(), &QLineEdit::editingFinished, this,
          [this] { finished_rate_ = question_.frames_per_s; });
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
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(command_line()); });
}

void AccuracyPage::name_parts() {
  first_words_->setText(
      tr("Set the required speed and error. The program measures once, on images of this finger, "
         "what each setting costs in time and gains in accuracy. Then it shows one answer here."));
  measure_->setText(tr("&Measure settings on this finger (about 12 s)"));
  measure_->setToolTip(tr("Computes error and time of many settings from the presses"));
  rate_label_->setText(tr("Images per &second"));
  rate_->setAccessibleName(tr("Images per second"));
  rate_->setToolTip(tr("Only settings that keep up with it are offered"));
  error_label_->setText(tr("Maximum er&ror"));
  error_->setAccessibleName(tr("Maximum error"));
  error_->setToolTip(tr("95 % of all points have a smaller depth error."));
  error_->setSuffix(tr(" mm"));
  error_->setSpecialValueText(tr("smallest possible"));
  as_calibrated_->setText(tr("Restore as cali&brated"));
  as_calibrated_->setToolTip(tr("Measures with the setting of the calibration again"));
  tabs_->setTabText(0, tr("Figure"));
  tabs_->setTabText(1, tr("Table"));
  tabs_->setTabText(2, tr("Live, side by side"));
  tabs_->tabBar()->setAccessibleName(tr("Figure, table or the live image with two settings"));
  copy_->setText(tr("Copy &command"));
  copy_->setToolTip(tr("Copies the command that does the same in a terminal"));
  command_->setAccessibleName(tr("The same as a command line"));
  bar_->setAccessibleName(tr("Progress of measuring"));
  stop_->setText(tr("Sto&p"));
  stop_->setToolTip(tr("Ends measuring; the settings so far are shown"));
  stop_->setToolTip(tr("Results so far are saved; measuring continues from there next time."));
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
  question_.frames_per_s = typed && is_rate(*typed) ? *typed : finished_rate_;
  const QString refused =
      !typed ? window_sentence(typed.error().what)
      : is_rate(*typed)
          ? QString()
          : window_sentence(en::say("must be an integer from {} to {}", kMinRate, kMaxRate));
  rate_->setToolTip(refused.isEmpty() ? tr("Only settings that keep up with it are offered")
                                      : refused);
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

namespace {

/// The name in files of the requested settings.
std::string name_of_use(const PipelineSettings& settings, const PipelineSettings& calibrated) {
  return key_of(settings) == key_of(calibrated) ? std::string()
                                                : words_of(settings, calibrated).english();
}

bool is_same_study(const FingerStudy& a, const FingerStudy& b) {
  const auto flags = [](const FingerStudy& study) {
    return std::array{study.is_of_finger_now, study.is_of_this_computer, study.has_all_single,
                      study.has_all_pairs};
  };
  return a.date == b.date && a.study.rows.size() == b.study.rows.size() && flags(a) == flags(b);
}

}  // namespace

FingerStudyRun::FingerStudyRun(QUndoStack& undo, std::string program_version, QObject* parent)
    : QObject(parent), undo_(undo), version_(std::move(program_version)) {
  connect(&work_, &BackgroundWork::progressed, this, &FingerStudyRun::changed);
  connect(&work_, &BackgroundWork::finished, this, &FingerStudyRun::changed);
  connect(&writing_, &BackgroundWork::finished, this, &FingerStudyRun::write_next);
}

void FingerStudyRun::open(const std::filesystem::path& folder) {
  if (folder != folder_) {
    work_.stop();
    folder_ = folder;
    take({});
  }
  if (!folder.empty()) read_folder();
}

FingerStudyRun::FolderState FingerStudyRun::state_of(const std::filesystem::path& folder) {
  FolderState folder_state;
  const auto finger = open_finger(folder);
  if (!finger) return folder_state;  // the window reports it
  folder_state.finger = *finger;
  auto stored = stored_study(*finger);
  if (!stored)
    folder_state.problem = stored.error();
  else if (*stored)
    folder_state.study = std::make_shared<const FingerStudy>(std::move(**stored));
  const auto measuring = presets_of_finger(folder);
  if (measuring)
    folder_state.in_use = {measuring->used, measuring->now};
  else
    folder_state.problem = measuring.error();
  return folder_state;
}

void FingerStudyRun::read_folder() {
  reading_.restart([this, folder = folder_](const Job&) {
    auto folder_state = std::make_shared<FolderState>(state_of(folder));
    return std::function<void()>([this, folder, folder_state] {
      if (folder != folder_) return;
      // A request that is not written yet takes precedence.
      if (!to_write_.empty() || writing_.is_running()) folder_state->in_use = now_.in_use;
      take(*folder_state);
    });
  });
}

void FingerStudyRun::take(const FolderState& folder_state) {
  // An unchanged study is not replaced, so that selections in it stay.
  const auto before = now_.study;
  now_ = folder_state;
  if (before && now_.study && is_same_study(*before, *now_.study)) now_.study = before;
  Q_EMIT changed();
}

void FingerStudyRun::start(StudyExtent extent) {
  if (is_running() || !now_.finger) return;
  now_.problem.reset();
  work_.start([this, finger = now_.finger, extent, version = version_](const Job& job) {
    const auto done = study_finger(finger, extent, version, job);
    std::optional<Error> problem;
    if (!done && !job.stop_requested()) problem = done.error();
    auto folder_state = std::make_shared<FolderState>(state_of(finger->folder));
    if (problem) folder_state->problem = problem;
    return std::function<void()>([this, folder = finger->folder, folder_state] {
      if (folder != folder_) return;
      folder_state->in_use = now_.in_use;
      take(*folder_state);
    });
  });
  Q_EMIT changed();
}

std::optional<std::size_t> FingerStudyRun::row_in_use() const {
  if (!now_.study) return std::nullopt;
  const auto& rows = now_.study->study.rows;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const StudyRow& row) {
    return key_of(row.settings) == key_of(now_.in_use.settings);
  });
  return found == rows.end() ? std::nullopt
                             : std::optional(static_cast<std::size_t>(found - rows.begin()));
}

void FingerStudyRun::use(std::size_t row) {
  if (!now_.study || row_in_use() == row) return;
  const auto& rows = now_.study->study.rows;
  const PipelineSettings& requested = rows[row].settings;
  undo_.push(new ValueChange<InUse>(
      [] { return tr("use other settings"); }, now_.in_use,
      InUse{name_of_use(requested, rows.front().settings), requested},
      [this, folder = folder_](const InUse& value) { set_in_use(folder, value); }));
}

void FingerStudyRun::set_in_use(const std::filesystem::path& folder, const InUse& requested) {
  to_write_.emplace_back(folder, requested);
  if (folder == folder_) now_.in_use = requested;
  write_next();
  Q_EMIT changed();
}

void FingerStudyRun::write_next() {
  if (writing_.is_running() || to_write_.empty()) return;
  const auto [folder, requested] = to_write_.front();
  to_write_.pop_front();
  writing_.start([this, folder = folder, requested = requested](const Job&) {
    const auto store = FingerStore::of(folder);
    const Status written = requested.name.empty()
                               ? use_calibrated_settings(*store)
                               : use_settings(*store, requested.settings, requested.name);
    return std::function<void()>([this, folder, written] {
      if (written || folder != folder_) return;
      now_.problem = written.error();
      read_folder();
      Q_EMIT changed();
    });
  });
}

// Texts and figures of the page Accuracy.

namespace {

constexpr double kMinReportedChange = 0.02;  // of time or error; smaller changes are not reported

QString millimetres(double mm) { return QLocale().toString(mm, 'f', mm < 0.1 ? 4 : 3); }

QString milliseconds(double ms) { return QLocale().toString(ms, 'f', 2); }

QString with_capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

QString AccuracyPage::row_words(const StudyRow& row) const {
  const QString words = difference_words(row.settings, shown_->study.rows.front().settings);
  return words.isEmpty() ? tr("as calibrated") : words;
}

QString AccuracyPage::figures_of(const StudyRow& row) const {
  QStringList clauses{
      tr("%1 ms per image; depth: half of all points within %2 mm, 95 % within %3 mm")
          .arg(milliseconds(frame_ms(shown_->study, row)), millimetres(row.depth->median_mm),
               millimetres(error_p95_mm(shown_->study, row).value_or(row.depth->p95_mm)))};
  if (row.position_mm)
    clauses << tr("position: half within %1 mm").arg(millimetres(*row.position_mm));
  return joined_clauses(clauses);
}

QString AccuracyPage::hint_of(const StudyRow& row) const {
  QStringList lines{figures_of(row)};
  if (!is_proven(row.settings, shown_->study.rows.front().settings))
    lines << tr("These images cannot show its loss: their light is that of the recording.");
  const QString other = difference_words(row.settings, run_.settings_in_use());
  if (other.isEmpty()) {
    lines << tr("In use now.");
    return lines.join(QLatin1Char('\n'));
  }
  lines << tr("Change from now: %1").arg(other);
  const auto in_use = run_.row_in_use();
  if (!in_use || !shown_->study.rows[*in_use].depth) return lines.join(QLatin1Char('\n'));
  const StudyRow& now = shown_->study.rows[*in_use];
  const double more_ms = frame_ms(shown_->study, row) - frame_ms(shown_->study, now);
  const double more_mm = row.depth->median_mm - now.depth->median_mm;
  if (std::abs(more_ms) > kMinReportedChange * frame_ms(shown_->study, now))
    lines << (more_ms < 0 ? tr("%1 ms faster than now") : tr("%1 ms slower than now"))
                 .arg(milliseconds(std::abs(more_ms)));
  if (std::abs(more_mm) > kMinReportedChange * now.depth->median_mm)
    lines << (more_mm < 0 ? tr("%1 mm more accurate than now") : tr("%1 mm less accurate than now"))
                 .arg(millimetres(std::abs(more_mm)));
  return lines.join(QLatin1Char('\n'));
}

std::optional<std::size_t> AccuracyPage::point_of_row(std::size_t row) const {
  const auto found = std::find(rows_.begin(), rows_.end(), row);
  return found == rows_.end() ? std::nullopt
                              : std::optional(static_cast<std::size_t>(found - rows_.begin()));
}

AccuracyPoint AccuracyPage::point_of(std::size_t number) const {
  const AccuracyStudy& study = shown_->study;
  const StudyRow& row = study.rows[number];
  AccuracyPoint point;
  point.words = row_words(row);
  point.hint = hint_of(row);
  point.time_ms = frame_ms(study, row);
  point.median_mm = row.depth->median_mm;
  point.p95_mm = error_p95_mm(study, row).value_or(row.depth->p95_mm);
  point.position_mm = row.position_mm;
  point.is_on_front = std::find(front_.begin(), front_.end(), number) != front_.end();
  point.is_in_use = run_.row_in_use() == number;
  point.is_proven = is_proven(row.settings, study.rows.front().settings);
  if (const auto better = dominated_by(study, front_, number))
    point.dominated_by = point_of_row(*better);
  return point;
}

QString AccuracyPage::study_obstacle() const {
  const FingerPtr& finger = run_.finger();
  if (folder_.empty()) return tr("Open a finger first.");
  if (!finger) return tr("The finger is being loaded.");
  if (!finger->mapping) return tr("Calibrate this finger first.");
  if (!finger->finger.reference) return tr("Record this finger's reference first.");
  return {};
}

void AccuracyPage::show_run() {
  show_progress();
  const QString reason = study_obstacle();
  first_reason_->setText(reason);
  measure_->setEnabled(reason.isEmpty() && !run_.is_running());
  measure_->setAccessibleDescription(reason);
  const std::string in_use = key_of(run_.settings_in_use());
  if (run_.study() == shown_ && in_use == shown_in_use_) return;
  if (run_.study() != shown_) picked_.reset();
  shown_ = run_.study();
  shown_in_use_ = in_use;
  pages_->setCurrentIndex(shown_ ? 1 : 0);
  show_points();
  show_answer();
}

void AccuracyPage::show_progress() {
  const bool is_running = run_.is_running();
  progress_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * run_.work().fraction()));
  const auto left = run_.work().seconds_left();
  left_->setText(left ? tr("about %n second(s) left", nullptr, static_cast<int>(std::ceil(*left)))
                      : tr("measuring the settings…"));
  more_->setEnabled(!is_running && study_obstacle().isEmpty());
  more_->setToolTip(tr("Computes error and time of further settings from the presses"));
}

void AccuracyPage::show_points() {
  rows_.clear();
  front_.clear();
  std::vector<AccuracyPoint> points;
  if (shown_) {
    front_ = pareto_front(shown_->study);
    for (std::size_t i = 0; i < shown_->study.rows.size(); ++i)
      if (shown_->study.rows[i].depth) rows_.push_back(i);
    for (const std::size_t row : rows_) points.push_back(point_of(row));
  }
  table_->set_points(points);
  plot_->set_points(std::move(points));
}

QString AccuracyPage::standing_text() const {
  if (!shown_->is_of_finger_now)
    return tr("The finger has changed since this was measured: measure again.");
  if (!shown_->is_of_this_computer)
    return tr("Measured on another computer (%1): its errors hold, its times do not.")
        .arg(QString::fromStdString(shown_->computer));
  if (!shown_->has_all_single) return tr("Measuring was stopped: some settings are missing.");
  return {};
}

QString AccuracyPage::answer_note() const {
  const AccuracyStudy& study = shown_->study;
  const auto rate_of = [&](std::size_t row) {
    return QLocale().toString(std::floor(1000 / frame_ms(study, study.rows[row])), 'f', 0);
  };
  if (picked_) return tr("Chosen by hand. Esc in the figure returns to the answer.");
  const QString budget = QLocale().toString(question_.budget_ms(), 'f', 1);
  const QString error = millimetres(question_.error_mm.value_or(0));
  switch (study_answer_->kind) {
    case StudyAnswerKind::kMostAccurate:
      return tr("The most accurate setting within %1 ms.").arg(budget);
    case StudyAnswerKind::kErrorMet:
      return tr("The fastest setting with 95 % of all points within %1 mm.").arg(error);
    case StudyAnswerKind::kErrorTooSmall:
      return tr("No setting reaches %1 mm. This is the most accurate within %2 ms.")
          .arg(error, budget);
    case StudyAnswerKind::kErrorTooSlow:
      return tr("An error of %1 mm allows %2 images per second. This is the most accurate setting "
                "that is fast enough.")
          .arg(error, rate_of(*study_answer_->within_error));
    case StudyAnswerKind::kTooSlow:
      break;
  }
  return tr("No setting is that fast on this computer. This is the fastest: %1 images per second.")
      .arg(rate_of(study_answer_->row));
}

void AccuracyPage::show_answer() {
  study_answer_ = shown_ ? answer_to(question_, shown_->study) : std::nullopt;
  const auto row = answer_row();
  const auto in_use = run_.row_in_use();
  if (row) {
    answer_->setText(with_capital(row_words(shown_->study.rows[*row])));
    figures_->setText(as_sentence(with_capital(figures_of(shown_->study.rows[*row]))));
    note_->setText(answer_note());
  } else {
    answer_->setText(shown_ ? tr("No setting can measure this finger's images.") : QString());
    figures_->clear();
    note_->clear();
  }
  const QString standing = shown_ ? standing_text() : QString();
  standing_->setText(standing);
  const bool is_used = row && in_use == row;
  use_->setText(is_used ? tr("In use") : tr("&Use it"));
  use_->setEnabled(row && !is_used);
  use_->setToolTip(
      tr("This finger is measured with the chosen setting from now on; undo takes it back"));
  as_calibrated_->setVisible(shown_ && in_use != std::size_t{0});
  if (shown_) {
    const bool is_good = shown_->is_of_finger_now && shown_->is_of_this_computer;
    more_->setText(!is_good                  ? tr("&Measure again (about 12 s)")
                   : !shown_->has_all_single ? tr("&Measure missing settings")
                                             : tr("&Measure setting pairs, too"));
    more_->setVisible(!is_good || !shown_->has_all_pairs);
  }
  command_->setText(command_line());
  command_->setCursorPosition(0);
  const auto point = row ? point_of_row(*row) : std::nullopt;
  plot_->pick(point);
  table_->pick(point);
  show_sides();
}

// Compares with the setting in use or, where that is the answer, with that of the calibration.
void AccuracyPage::show_sides() {
  if (!shown_) return;
  const auto& rows = shown_->study.rows;
  const auto words = [&](const PipelineSettings& settings) {
    const QString other = difference_words(settings, rows.front().settings);
    return other.isEmpty() ? tr("as calibrated") : other;
  };
  const PipelineSettings& now = run_.settings_in_use();
  const auto row = answer_row();
  const PipelineSettings& chosen =
      row && run_.row_in_use() != row ? rows[*row].settings : rows.front().settings;
  sides_->compare(run_.finger(), {now, words(now)}, {chosen, words(chosen)});
}

QString AccuracyPage::command_line() const {
  if (folder_.empty()) return {};
  std::string command = fmt::format("alltact study {} --within-ms {:.4g}",
                                    shell_quoted(folder_.string()), question_.budget_ms());
  if (question_.error_mm) command += fmt::format(" --keep-mm {:g}", *question_.error_mm);
  return QString::fromStdString(command);
}

}  // namespace alltact
