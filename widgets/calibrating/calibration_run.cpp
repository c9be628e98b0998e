#include "widgets/calibrating/calibration_run.h"

#include "calibration/finger/calibration_file.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/language.h"
#include "widgets/report/calibration_pages.h"
#include "widgets/undo_step.h"

#include <algorithm>
#include <mutex>
#include <set>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Files that a calibration writes, besides the presses and finger.yaml.
constexpr const char* kWritten[] = {CalibrationInputs::kFileName, kCalibrationFile, kReportJson,
                                    kReportHtml, kReportPdf};

std::map<std::string, std::optional<std::string>> read_written(const fs::path& folder) {
  std::map<std::string, std::optional<std::string>> files;
  for (const char* name : kWritten) {
    auto content = read_file(folder / name);
    files[name] = content ? std::optional(std::move(*content)) : std::nullopt;
  }
  return files;
}

/// Puts `files` in the folder and the calibration of `from` in its finger.yaml, all together or
/// none. `replaced` receives the files that were there.
Status put_back(const fs::path& folder,
                const std::map<std::string, std::optional<std::string>>& files,
                const FingerPtr& from,
                std::map<std::string, std::optional<std::string>>& replaced) {
  replaced = read_written(folder);
  auto change = FolderChange::begin(folder);
  if (!change) return change.error();
  for (const auto& [name, content] : files) {
    if (!content) {
      change->remove(name);
    } else if (const Status written = write_file_atomically(change->staged() / name, *content);
               !written) {
      return written;
    }
  }
  if (!from) return change->commit();
  const auto changed = FingerStore::of(folder)->update([&](Finger& now) {
    take_calibration(from->finger, now);
    return commit_with(now, *change);
  });
  return changed ? Status() : changed.error();
}

}  // namespace

/// Written by the calibrating thread, read by the window's thread.
struct CalibrationRun::SharedRounds {
  std::mutex mutex;
  std::vector<Round> rounds;
};

/// Undo step of a calibration: restores the files written before it. The disk's thread reads and
/// writes them.
class CalibrationRun::Undo : public UndoStep {
 public:
  Undo(CalibrationRun& run, Files before, Outcome outcome_before, Outcome outcome_after)
      : UndoStep([] { return tr("calibrate"); }),
        run_(run),
        folder_(run.collection_.folder()),
        before_(std::make_shared<Files>(std::move(before))),
        has_report_before_(before_->at(kReportHtml).has_value()),
        outcome_before_(std::move(outcome_before)),
        outcome_after_(std::move(outcome_after)) {}

  void undo() override {
    if (run_.collection_.folder() != folder_) return;
    run_.report_.stop();
    is_undone_ = true;
    has_report_after_ = run_.has_report_;
    run_.restore(before_, has_report_before_, outcome_before_, after_);
  }
  void redo() override {
    if (!is_undone_ || run_.collection_.folder() != folder_)
      return;  // called when the step is pushed
    run_.report_.stop();
    run_.restore(after_, has_report_after_, outcome_after_, before_);
  }

 private:
  CalibrationRun& run_;
  fs::path folder_;
  std::shared_ptr<Files> before_, after_ = std::make_shared<Files>();
  bool is_undone_ = false, has_report_before_ = false, has_report_after_ = false;
  Outcome outcome_before_, outcome_after_;
};

CalibrationRun::CalibrationRun(PressCollection& collection, QUndoStack& undo,
                               std::string program_version, QObject* parent)
    : QObject(parent), collection_(collection), undo_(undo), version_(std::move(program_version)) {
  connect(&work_, &BackgroundWork::progressed, this, &CalibrationRun::changed);
  connect(&work_, &BackgroundWork::finished, this, &CalibrationRun::changed);
  connect(&report_, &ReportWriter::finished, this, [this] {
    has_report_ = !report_.problem();
    Q_EMIT changed();
  });
  // What can be started depends on the presses.
  connect(&collection_, &PressCollection::changed, this, &CalibrationRun::changed);
}

void CalibrationRun::reload() {
  const fs::path folder = collection_.folder();
  if (folder != loaded_folder_) {
    report_.stop();
    now_ = {};
    problem_.reset();
    loaded_folder_ = folder;
  }
  if (folder.empty()) return void(Q_EMIT changed());
  if (is_running()) return;  // the running calibration updates everything when done
  loading_.restart([this, folder, disk = collection_.disk()](const Job&) {
    disk->wait();
    auto inputs = std::make_shared<Result<CalibrationInputs>>(CalibrationInputs::load(folder));
    const auto finger = open_finger(folder);
    const FingerPtr opened = finger ? *finger : nullptr;
    std::optional<FingerWorth> worth;
    if (opened) worth = worth_of(*opened, utc_now());
    std::error_code failed;
    const bool has_report = fs::exists(folder / kReportHtml, failed);
    std::shared_ptr<const FingerCalibration> stored;
    if (auto calibration = stored_calibration(folder))
      stored = std::make_shared<const FingerCalibration>(std::move(*calibration));
    return std::function<void()>([this, folder, inputs, opened, worth, has_report, stored] {
      if (folder != collection_.folder()) return reload();
      if (*inputs) now_.inputs = **inputs;
      if (opened) now_.finger = opened, now_.worth = worth;
      // The result of this session also holds the presses' images.
      if (stored && !(now_.result && now_.result->inputs.to_yaml() == stored->inputs.to_yaml()))
        now_.result = stored;
      if (!is_writing_report()) has_report_ = has_report;
      Q_EMIT changed();
    });
  });
}

CalibrationState CalibrationRun::state() const {
  if (!now_.finger || !now_.finger->mapping || !now_.inputs) return CalibrationState::kNone;
  if (now_.worth && now_.worth->must_repeat) return CalibrationState::kStale;
  if (!collection_.is_ready()) return CalibrationState::kCurrent;  // nothing could be changed yet
  const auto& presses = collection_.presses();
  const bool same_presses = std::equal(presses.begin(), presses.end(), now_.inputs->presses.begin(),
                                       now_.inputs->presses.end(),
                                       [](const CollectedPress& press, const StoredPress& stored) {
                                         return press.name == stored.name;
                                       });
  return same_presses && input_for(collection_.press_set()).press_set == now_.inputs->press_set
             ? CalibrationState::kCurrent
             : CalibrationState::kStale;
}

FingerCalibrationInput CalibrationRun::input_for(const PressSet& press_set) const {
  FingerCalibrationInput input;
  input.folder = collection_.folder();
  input.presses.files = {collection_.folder() / kPressFolder};
  if (now_.inputs) {  // settings of this finger's last calibration
    input.calibration = now_.inputs->calibration;
    input.pipeline = now_.inputs->pipeline;
  }
  std::set<std::string> presses;
  for (const CollectedPress& press : collection_.presses()) presses.insert(press.name);
  input.press_set = press_set.only(presses);
  input.program_version = version_;
  return input;
}

FingerCalibrationInput CalibrationRun::stored_input() const {
  FingerCalibrationInput input = input_for(now_.inputs->press_set);
  input.date = now_.inputs->date;
  input.compare_methods = now_.result && !now_.result->methods.empty();
  return input;
}

QString CalibrationRun::command_line() const {
  return QString::fromStdString(calibrate_command(
      state() == CalibrationState::kCurrent ? stored_input() : input_for(collection_.press_set())));
}

CalibrationInputs CalibrationRun::next_inputs() const {
  const FingerCalibrationInput input = input_for(collection_.press_set());
  CalibrationInputs inputs;
  inputs.press_set = input.press_set;
  inputs.calibration = input.calibration;
  inputs.pipeline = input.pipeline;
  return inputs;
}

void CalibrationRun::take(const Outcome& made) {
  now_ = made;
  problem_.reset();
}

void CalibrationRun::start() {
  FingerCalibrationInput input = input_for(collection_.press_set());
  input.date = utc_now();
  run(std::move(input));
}

void CalibrationRun::compare() {
  if (!can_compare()) return;
  FingerCalibrationInput input = stored_input();
  input.compare_methods = input.discard_if_stopped = true;
  run(std::move(input));
}

void CalibrationRun::run(FingerCalibrationInput input) {
  if (is_running()) return;
  report_.stop();
  // Presses without a frame in memory are read from their files.
  const auto& presses = collection_.presses();
  if (std::all_of(presses.begin(), presses.end(),
                  [](const CollectedPress& one) { return one.frame; }))
    for (const CollectedPress& press : presses) input.presses.frames.push_back(press.frame);
  rounds_ = std::make_shared<SharedRounds>();
  input.on_round = [shared = rounds_](const Round& round) {
    const std::lock_guard lock(shared->mutex);
    shared->rounds.push_back(round);
  };
  struct Done {
    Files files;
    Outcome before, after;
    std::optional<Result<FingerCalibration>> result;
  };
  auto done = std::make_shared<Done>();
  done->before = now_;
  done->before.finger.reset();
  work_.start([this, input, done, disk = collection_.disk()](const Job& job) {
    disk->wait();
    done->files = read_written(input.folder);
    if (const auto finger = open_finger(input.folder)) done->before.finger = *finger;
    done->result.emplace(calibrate_finger(input, job));
    if (const auto finger = open_finger(input.folder)) {
      done->after.finger = *finger;
      done->after.worth = worth_of(**finger, utc_now());
    }
    return std::function<void()>([this, done, input] {
      if (input.folder != collection_.folder()) return;
      if (!*done->result) {
        problem_ = done->result->error();
        return;
      }
      auto result = std::make_shared<const FingerCalibration>(std::move(**done->result));
      done->after.result = result;
      done->after.inputs = result->inputs;
      take(done->after);
      has_report_ = false;
      if (!input.compare_methods)  // which adds to the report alone
        undo_.push(new Undo(*this, std::move(done->files), done->before, done->after));
      report_.start(result, input.folder);
    });
  });
  Q_EMIT changed();
}

void CalibrationRun::stop() { work_.stop(); }

std::vector<Round> CalibrationRun::rounds() const {
  if (!rounds_) return {};
  const std::lock_guard lock(rounds_->mutex);
  return rounds_->rounds;
}

void CalibrationRun::restore(std::shared_ptr<Files> files, bool has_report, const Outcome& made,
                             std::shared_ptr<Files> replaced) {
  take(made);
  has_report_ = has_report;
  const fs::path folder = collection_.folder();
  collection_.disk()->add(
      folder / Finger::kFileName,
      [folder, files = std::move(files), replaced = std::move(replaced),
       finger = made.finger]() -> Status { return put_back(folder, *files, finger, *replaced); });
  if (loading_.is_running()) reload();  // its result would be of the former files
  Q_EMIT changed();
}

fs::path CalibrationRun::report() const {
  return has_report_ && !is_writing_report() ? collection_.folder() / kReportHtml : fs::path();
}

PressForecast::PressForecast(const PressCollection& collection, const CalibrationRun& run,
                             QObject* parent)
    : QObject(parent), collection_(collection), run_(run) {
  delay_.setSingleShot(true);
  delay_.setInterval(kDelay_ms);
  connect(&delay_, &QTimer::timeout, this, &PressForecast::begin);
  connect(&collection_, &PressCollection::changed, this, &PressForecast::follow);
  connect(&run_, &CalibrationRun::changed, this, &PressForecast::follow);
  connect(&work_, &BackgroundWork::finished, this, &PressForecast::follow);
}

void PressForecast::set_watched(bool is_watched) {
  is_watched_ = is_watched;
  if (!is_watched) {
    delay_.stop();
    work_.stop();
  }
  follow();
}

PressForecast::Presses PressForecast::present() const {
  Presses presses;
  presses.press_set = run_.next_inputs().press_set;
  for (const CollectedPress& press : collection_.presses())
    if (press.analysis.measured) presses.measured.push_back(press.analysis.measured);
  return presses;
}

bool PressForecast::is_needed() const {
  if (!collection_.is_ready() || collection_.analyser() == nullptr ||
      run_.state() == CalibrationState::kCurrent)
    return false;
  return std::any_of(collection_.presses().begin(), collection_.presses().end(),
                     [this](const auto& press) {
                       return collection_.is_usable(press) && collection_.has_ball(press);
                     });
}

void PressForecast::follow() {
  if (folder_ != collection_.folder()) last_.reset();
  folder_ = collection_.folder();
  const bool is_needed_now = is_needed();
  if (!is_needed_now || present() != requested_) {
    const bool was_known = result_ || problem_;
    result_.reset();
    problem_.reset();
    requested_ = {};
    work_.stop();
    if (was_known) Q_EMIT changed();
  }
  if (!is_needed_now) return delay_.stop();
  // A run that starts takes the forecast's solution; one that began later would only wait for it.
  if (is_watched_ && requested_ == Presses() && !collection_.is_analysing() &&
      !work_.is_running() && !run_.is_running())
    delay_.start();  // restarts with every change
}

void PressForecast::begin() {
  if (work_.is_running() || run_.is_running() || !is_needed() || collection_.is_analysing()) return;
  requested_ = present();
  work_.start([this, requested = requested_, inputs = run_.next_inputs(),
               finger = collection_.analyser()->finger(),
               folder = collection_.folder()](const Job& job) {
    std::vector<MeasuredPress> presses;
    for (const auto& press : requested.measured) presses.push_back(*press);
    auto made = std::make_shared<Result<FingerCalibration>>(
        forecast_calibration(finger, folder, std::move(presses), inputs, job));
    return std::function<void()>([this, requested, made, is_stopped = job.stop_requested()] {
      if (requested != requested_) return;
      if (is_stopped) return void(requested_ = {});
      if (*made)
        result_ = last_ = std::make_shared<const FingerCalibration>(std::move(**made));
      else
        problem_ = made->error();
      Q_EMIT changed();
    });
  });
  Q_EMIT changed();
}

const FingerCalibration* PressForecast::baseline() const {
  return run_.result() ? run_.result().get() : last_.get();
}

std::optional<Verdict> verdict_of(const CalibrationRun& run) {
  const auto& worth = run.worth();
  return worth && worth->evidence ? std::optional(window_verdict(*worth->evidence)) : std::nullopt;
}

QString recalibration_reason(const CalibrationRun& run) {
  if (run.state() != CalibrationState::kStale) return {};
  const auto known = verdict_of(run);
  QStringList reasons;
  for (std::size_t i = 0; known && i < known->missing.size(); ++i)
    if (known->missing_names[i] == "numbers_unchanged" ||
        known->missing_names[i] == "reference_older")
      reasons << window_sentence(known->missing[i]);
  if (reasons.isEmpty())
    reasons << VerdictPage::tr("The presses have changed since this calibration.");
  return reasons.join(QLatin1Char(' '));
}

QString forecast_text(const PressForecast& forecast, const CalibrationRun& run) {
  if (forecast.problem())
    return VerdictPage::tr("The current presses give no calibration: %1")
        .arg(window_sentence(forecast.problem()->what));
  const auto& then = forecast.result();
  if (!then)
    return forecast.is_working()
               ? VerdictPage::tr("The result of the current presses is being computed.")
               : QString();
  const QString now =
      VerdictPage::tr("With the current presses: %1 mm, %2")
          .arg(local_mm(then->verdict.error_mm, 3), grade_text(then->verdict.grade));
  const auto used = verdict_of(run);
  return used ? VerdictPage::tr("%1 (in use: %2 mm).").arg(now, local_mm(used->error_mm, 3))
              : as_sentence(now);
}

}  // namespace alltact
