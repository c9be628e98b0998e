#include "widgets/calibrating/check_page.h"

#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"
#include "core/live/source_runner.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/press_guide.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/language.h"
#include "widgets/report/document.h"
#include "widgets/shell/page.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QApplication>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLocale>
#include <QSettings>
#include <QVBoxLayout>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kCheckSideWidth = 330, kCheckSymbol = 28, kLongestName = 80;
constexpr QLatin1String kOperatorKey{"check/operator"};

/// Local date and time in the window's language.
QString date_text(const std::string& utc) {
  const auto seconds = unix_seconds(utc);
  if (!seconds) return as_text(utc);
  const auto when = QDateTime::fromSecsSinceEpoch(static_cast<qint64>(*seconds));
  return moment_text(when);
}

/// Result of one check, and the history file before and after it.
struct Checked {
  std::optional<Error> problem;
  std::optional<PressCheck> check;
  std::optional<std::string> before, after;
};

std::optional<std::string> content_of(const fs::path& file) {
  auto content = read_file(file);
  return content ? std::optional(std::move(*content)) : std::nullopt;
}

Checked check_frames(const fs::path& folder, const std::vector<FramePtr>& frames,
                     const std::string& operator_name, const std::string& version, const Job& job) {
  Checked checked;
  const auto fail = [&checked](const Error& error) {
    checked.problem = error;
    return checked;
  };
  const auto finger = open_finger(folder);
  if (!finger) return fail(finger.error());
  PressInput presses;
  presses.frames = frames;
  const auto check = check_with_presses(**finger, presses, {}, job);
  if (!check) return fail(check.error());
  checked.before = content_of(folder / kCheckFile);
  const Status appended =
      append_check(folder, entry_of(*check, (*finger)->finger, utc_now(), version, operator_name));
  if (!appended) return fail(appended.error());
  checked.after = content_of(folder / kCheckFile);
  checked.check = *check;
  return checked;
}

}  // namespace

CheckPage::CheckPage(LiveSession& session, PressCollection& collection, const CalibrationRun& run,
                     QUndoStack& undo, std::string program_version, QWidget* parent)
    : StepPage(parent),
      session_(session),
      collection_(collection),
      run_(run),
      undo_(undo),
      version_(std::move(program_version)),
      live_(new ImagePanel(session)),
      take_group_(new QGroupBox),
      verdict_group_(new QGroupBox),
      how_(wrapped_text()),
      operator_label_(new QLabel),
      symbol_(new QLabel),
      verdict_(wrapped_label()),
      sentence_(wrapped_text()),
      operator_(new QLineEdit),
      count_(new ReservedText),
      take_(new QPushButton),
      again_(new QPushButton),
      check_(new QPushButton),
      bar_(new QProgressBar),
      plot_(new HistoryPlot) {
  auto* column = without_margins(new QVBoxLayout(this));
  ViewOptions options;
  options.direction = options.markers = false;  // only depth is drawn over the contact
  live_->set_options(options);
  auto* row = new QHBoxLayout;
  row->addWidget(live_, 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  connect(take_, &QPushButton::clicked, this, &CheckPage::take);
  new SpaceKey(*this, [this] {
    if (take_->isEnabled()) take();
  });
  connect(again_, &QPushButton::clicked, this,
          [this] { set_taken([] { return tr("begin the check again"); }, {}); });
  connect(check_, &QPushButton::clicked, this, &CheckPage::check);
  connect(&work_, &BackgroundWork::progressed, this, &CheckPage::show_status);
  connect(&work_, &BackgroundWork::finished, this, &CheckPage::show_status);
  connect(&run_, &CalibrationRun::changed, this, [this] {
    show_verdict();  // of another calibration
    show_status();
    Q_EMIT changed();
  });
  connect(&session_, &LiveSession::view_ready, this, &CheckPage::watch);
  connect(&session_, &LiveSession::status_ready, this, [this] {
    follow_source();
    show_status();
  });
  say([this] {
    take_group_->setTitle(tr("Three presses"));
    verdict_group_->setTitle(tr("Verdict"));
    how_->setText(
        tr("Press the calibration ball at three positions, base, middle and tip, and take an image "
           "of each. The calibration does not change."));
    take_->setText(tr("&Take a press (Space)"));
    take_->setToolTip(tr("Stores the present image as a press of the ball"));
    again_->setText(tr("&Begin again"));
    again_->setToolTip(tr("Discards the presses of this check"));
    check_->setText(tr("&Check now"));
    check_->setToolTip(
        tr("Compares the measured depth with the ball, and adds the result to the history"));
    operator_label_->setText(tr("O&perator"));
    operator_->setAccessibleName(tr("Operator"));
    operator_->setToolTip(tr("Your name or initials, stored with the check"));
    operator_->setToolTip(
        tr("Stored with the check: it separates operators from repetitions in a gage study."));
    bar_->setAccessibleName(tr("Progress of the check"));
    count_->reserve_for(
        {waiting_words(PressTaker::State::kWaits), waiting_words(PressTaker::State::kRefused)});
    show_history();
    show_verdict();
    show_status();
  });
}

QWidget* CheckPage::make_side() {
  const SidePanel side(kCheckSideWidth);
  auto* take = new QVBoxLayout(take_group_);
  set_primary(*check_, false);  // later it is: its width is that of a bold text
  reserve_room(*bar_);
  reserve_room(*symbol_);
  add_widgets(*take, {how_, take_, count_});
  auto* person = new QHBoxLayout;
  add_widgets(*person, {operator_label_, operator_});
  operator_label_->setBuddy(operator_);
  operator_->setMaxLength(kLongestName);
  operator_->setText(QSettings().value(kOperatorKey).toString());
  // The next key must not be typed into the field.
  connect(operator_, &QLineEdit::returnPressed, this, [this] { take_->setFocus(); });
  take->addLayout(person);
  auto* row = new QHBoxLayout;
  row->addWidget(check_);
  row->addWidget(again_);
  row->addWidget(bar_, 1);
  row->addStretch();
  take->addLayout(row);
  side.column->addWidget(take_group_);
  auto* inside = new QVBoxLayout(verdict_group_);
  auto* head = new QHBoxLayout;
  head->addWidget(symbol_);
  QFont large = verdict_->font();
  large.setPointSizeF(1.4 * large.pointSizeF());
  large.setBold(true);
  verdict_->setFont(large);
  head->addWidget(verdict_, 1);
  inside->addLayout(head);
  inside->addWidget(sentence_);
  inside->addWidget(plot_, 1);
  side.column->addWidget(verdict_group_, 1);
  foot_ = side.foot;
  return side.root;
}

const CheckEntry* CheckPage::latest() const {
  return run_.finger() ? latest_check(history_, run_.finger()->finger) : nullptr;
}

StepState CheckPage::state() const {
  const CheckEntry* check = latest();
  if (check == nullptr) return StepState::kToDo;
  const bool holds =
      verdict_now(*check) == CheckVerdict::kPass && run_.state() == CalibrationState::kCurrent;
  return holds ? StepState::kDone : StepState::kOutdated;
}

const QPushButton* CheckPage::action_button() const {
  const bool is_just_checked = last_ && taken_.empty();
  if (work_.is_running() || is_just_checked) return nullptr;
  return static_cast<int>(taken_.size()) < kCheckPresses ? take_ : check_;
}

void CheckPage::forget_taken() {
  taken_.clear();
  last_.reset();
  set_problems({});
  show_verdict();
  show_status();
}

void CheckPage::check() {
  set_problems({});
  const QString person = operator_->text().trimmed();
  QSettings().setValue(kOperatorKey, person);
  work_.start([this, folder = folder_, frames = taken_, person = person.toStdString(),
               version = version_](const Job& job) {
    auto checked = std::make_shared<Checked>(check_frames(folder, frames, person, version, job));
    return std::function<void()>([this, checked, folder] {
      if (folder != folder_) return;
      if (checked->problem) return set_problems({Problem::of(*checked->problem)});
      taken_.clear();
      last_ = checked->check;
      undo_.push(new ValueChange<std::optional<std::string>>(
          [] { return tr("check"); }, checked->before, checked->after,
          [this, folder](const std::optional<std::string>& content) {
            if (folder == folder_) write_history(content);
          }));
      show_verdict();
      Q_EMIT this->checked();
    });
  });
  show_status();
}

void CheckPage::write_history(const std::optional<std::string>& content) {
  collection_.disk()->add(folder_ / kCheckFile, [file = folder_ / kCheckFile, content]() -> Status {
    if (content) return write_file_atomically(file, *content);
    std::error_code failed;
    fs::remove(file, failed);
    return {};
  });
  load_history();
}

void CheckPage::load_history() {
  loading_.restart([this, folder = folder_, disk = collection_.disk()](const Job&) {
    disk->wait();
    const auto checks = load_checks(folder, nullptr);
    return std::function<void()>([this, checks, folder] {
      if (folder != folder_) return;
      history_ = checks ? *checks : std::vector<CheckEntry>();
      if (!checks) set_problems({Problem::of(checks.error())});
      show_history();
      show_verdict();
      Q_EMIT changed();
    });
  });
}

void CheckPage::show_history() {
  HistoryData data;
  for (const CheckEntry& check : history_) {
    data.points.push_back({unix_seconds(check.time).value_or(0), check.error_mm});
    data.drifting_above_mm = check.drifting_above_mm;
    data.recalibrate_above_mm = check.recalibrate_above_mm;
  }
  plot_->set_data(std::move(data));
}

QString CheckPage::verdict_words(const CheckEntry& check) const {
  QStringList lines;
  if (const QString stale = recalibration_reason(run_); !stale.isEmpty()) lines << stale;
  if (!last_ || last_->verdict != check.verdict) {
    lines << tr("Last checked on %1 with %n press(es): error %2 mm (limit %3 mm).", nullptr,
                check.presses)
                 .arg(date_text(check.time), local_mm(check.error_mm, 3),
                      local_mm(check.drifting_above_mm, 3));
    if (verdict_now(check) == CheckVerdict::kTooFew)
      lines
          << tr("A check needs %1 presses at different positions: press again.").arg(kCheckPresses);
    return lines.join(QLatin1Char('\n'));
  }
  lines << window_sentence(last_->sentence);
  for (const Message& press : last_->left_out)
    lines << tr("Left out: %1").arg(in_window_language(press));
  return lines.join(QLatin1Char('\n'));
}

void CheckPage::show_verdict() {
  const CheckEntry* check = latest();
  symbol_->setVisible(check != nullptr);
  if (check == nullptr) {
    verdict_->setText(tr("Not checked yet"));
    sentence_->setText(history_.empty()
                           ? QString()
                           : tr("The last check, on %1, tested an earlier calibration.")
                                 .arg(date_text(history_.back().time)));
    return;
  }
  const CheckVerdict word = verdict_now(*check);
  const bool is_stale = run_.state() == CalibrationState::kStale;
  const Meaning meaning =
      is_stale ? std::max(meaning_of(word), Meaning::kDoubtful) : meaning_of(word);
  symbol_->setPixmap(symbol(meaning_symbol(meaning), meaning_colour(meaning, palette()),
                            kCheckSymbol, devicePixelRatioF()));
  verdict_->setText(is_stale ? changed_text() : check_text(word));
  sentence_->setText(verdict_words(*check));
}

void CheckPage::show_status() {
  if (folder_ != collection_.folder()) {
    folder_ = collection_.folder();
    history_.clear();
    forget_taken();
    if (!folder_.empty()) load_history();
    return;
  }
  const QString reason = take_obstacle();
  const int count = static_cast<int>(taken_.size());
  take_->setEnabled(reason.isEmpty());
  count_->setText(!reason.isEmpty()                            ? reason
                  : taker_.state() != PressTaker::State::kIdle ? waiting_words(taker_.state())
                  : count < kCheckPresses ? tr("%1 of %2 taken.").arg(count).arg(kCheckPresses)
                                          : tr("%n press(es) taken: enough.", nullptr, count));
  check_->setEnabled(count >= kCheckPresses && reason.isEmpty());
  again_->setEnabled(count > 0 && !work_.is_running());
  bar_->setVisible(work_.is_running());
  bar_->setValue(static_cast<int>(100 * work_.fraction()));
  Q_EMIT changed();
}

void CheckPage::changeEvent(QEvent* event) {
  StepPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_verdict();
}

// Taking presses for the step Check, as in the step Presses: while they are held still.

QString CheckPage::take_obstacle() const {
  if (!session_.view()) return tr("There is no live image: choose a source.");
  if (run_.state() == CalibrationState::kNone) return tr("The finger is not calibrated.");
  if (work_.is_running()) return tr("The check is running.");
  return {};
}

void CheckPage::press_pedal() {
  if (take_->isEnabled()) take();
}

void CheckPage::take() {
  if (!take_obstacle().isEmpty()) return;
  live_->freeze(false);
  const auto taken = taker_.request(monotonic_s());
  if (taken) add_taken(*taken);
  follow_source();
  show_status();
}

void CheckPage::add_taken(const PressTaker::Taken& taken) {
  auto copy = std::make_shared<Frame>(*taken.frame);
  copy->name = "check_" + std::to_string(taken_.size() + 1);
  copy->jpeg.reset();
  auto more = taken_;
  more.push_back(copy);
  set_taken([] { return tr("take a press for the check"); }, std::move(more));
  live_->flash(tr("Press %1").arg(taken_.size()));
  QApplication::beep();
}

void CheckPage::watch() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const auto waited = taker_.state();
  if (const auto taken = taker_.see(result.frame, dark_patch(result), monotonic_s()))
    add_taken(*taken);
  if (taker_.state() != waited) show_status();
}

void CheckPage::follow_source() {
  if (session_.status().source.state != SourceState::kEnded) return;
  if (const auto last = taker_.end()) add_taken(*last);
}

void CheckPage::hideEvent(QHideEvent* event) {
  taker_.forget();
  StepPage::hideEvent(event);
}

void CheckPage::set_taken(const StepWords& what, std::vector<FramePtr> frames) {
  undo_.push(new ValueChange<std::vector<FramePtr>>(
      what, taken_, std::move(frames),
      [this, folder = folder_](const std::vector<FramePtr>& restored) {
        if (folder != folder_) return;
        taken_ = restored;
        show_status();
      }));
}

}  // namespace alltact
