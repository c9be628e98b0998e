#include "widgets/calibrating/calibration_run.h"

#include "calibration/finger/calibration_report.h"
#include "calibration/finger/recall_calibration.h"
#include "core/io/atomic_file.h"
#include "core/utc_time.h"
#include "widgets/report/calibration_pages.h"
#include "widgets/undo_step.h"

#include <algorithm>
#include <mutex>
#include <set>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// All that a calibration writes beside the presses and finger.yaml.
constexpr const char* kWritten[] = {
    CalibrationInputs::kFileName, kReportFigures, kReportPage, kReportPaper};

std::map<std::string, std::optional<std::string>> read_written(const fs::path& folder) {
  std::map<std::string, std::optional<std::string>> files;
  for (const char* name : kWritten) {
    auto content = read_file(folder / name);
    files[name] = content ? std::optional(std::move(*content)) : std::nullopt;
  }
  return files;
}

Status write_written(const fs::path& folder,
                     const std::map<std::string, std::optional<std::string>>& files) {
  for (const char* name : kWritten) {
    const auto& content = files.at(name);
    if (content) {
      if (const Status status = write_file_atomically(folder / name, *content); !status)
        return status;
    } else {
      std::error_code absent;
      fs::remove(folder / name, absent);
    }
  }
  return {};
}

}  // namespace

/// Told on one thread, shown on another.
struct CalibrationRun::HeardRounds {
  std::mutex mutex;
  std::vector<Round> rounds;
};

/// A calibration as a step: what was written before it is put back.
class CalibrationRun::Undo : public UndoStep {
 public:
  Undo(CalibrationRun& run, Files before, Made made_before, Made made_after)
      : UndoStep([] { return tr("calibrate"); }),
        run_(run),
        folder_(run.desk_.folder()),
        before_(std::move(before)),
        made_before_(std::move(made_before)),
        made_after_(std::move(made_after)) {}

  void undo() override {
    if (run_.desk_.folder() != folder_) return;
    run_.report_.stop();
    run_.desk_.disk()->wait();
    after_ = read_written(folder_);
    run_.restore(before_, made_before_);
  }
  void redo() override {
    if (after_.empty() || run_.desk_.folder() != folder_) return;  // the first time it is done
    run_.report_.stop();
    run_.restore(after_, made_after_);
  }

 private:
  CalibrationRun& run_;
  fs::path folder_;
  Files before_, after_;
  Made made_before_, made_after_;
};

CalibrationRun::CalibrationRun(PressDesk& desk,
                               QUndoStack& undo,
                               std::string program_version,
                               QObject* parent)
    : QObject(parent), desk_(desk), undo_(undo), version_(std::move(program_version)) {
  connect(&work_, &BackgroundWork::progressed, this, &CalibrationRun::changed);
  connect(&work_, &BackgroundWork::finished, this, &CalibrationRun::changed);
  connect(&report_, &ReportWriter::finished, this, [this] {
    has_report_ = !report_.problem();
    Q_EMIT changed();
  });
  // What is asked for comes first: the list of presses and the live picture.
  connect(&desk_, &PressDesk::changed, this, &CalibrationRun::recall_residuals_once);
  connect(&recalling_, &BackgroundWork::finished, this, &CalibrationRun::recall_residuals_once);
}

void CalibrationRun::reload() {
  const fs::path folder = desk_.folder();
  if (folder != looked_at_) {
    report_.stop();
    recalling_.stop();
    result_.reset();
    from_.reset();
    finger_.reset();
    worth_.reset();
    problem_.reset();
    recall_problem_.reset();
    lacks_residuals_ = false;
    looked_at_ = folder;
  }
  if (folder.empty()) return void(Q_EMIT changed());
  if (is_running()) return;  // which looks when it is done
  loading_.restart([this, folder, disk = desk_.disk()](const Job&) {
    disk->wait();
    auto inputs = std::make_shared<Result<CalibrationInputs>>(CalibrationInputs::load(folder));
    const auto finger = open_finger(folder);
    const FingerPtr opened = finger ? *finger : nullptr;
    std::optional<FingerWorth> worth;
    if (opened) worth = worth_of(*opened, utc_now());
    std::error_code failed;
    const bool has_report = fs::exists(folder / kReportPage, failed);
    std::shared_ptr<const FingerCalibration> recalled;
    if (auto kept = recall_calibration(folder))
      recalled = std::make_shared<const FingerCalibration>(std::move(*kept));
    return std::function<void()>([this, folder, inputs, opened, worth, has_report, recalled] {
      if (folder != desk_.folder()) return reload();
      if (*inputs) from_ = **inputs;
      if (opened) finger_ = opened, worth_ = worth;
      if (recalled) take_recalled(recalled);
      if (!is_writing_report()) has_report_ = has_report;
      Q_EMIT changed();
    });
  });
}

void CalibrationRun::take_recalled(const std::shared_ptr<const FingerCalibration>& recalled) {
  if (result_ && result_->inputs.to_yaml() == recalled->inputs.to_yaml()) return;
  result_ = recalled;
  lacks_residuals_ = true;
  recall_residuals_once();
}

void CalibrationRun::recall_residuals_once() {
  if (!lacks_residuals_ || recalling_.is_running() || !desk_.is_ready() || desk_.is_looking())
    return;
  lacks_residuals_ = false;
  recall_problem_.reset();
  recalling_.start([this, folder = desk_.folder(), bare = result_, disk = desk_.disk()](
                       const Job& job) {
    disk->wait();
    auto whole = std::make_shared<Result<FingerCalibration>>(recall_residuals(folder, *bare, job));
    return std::function<void()>([this, bare, whole] {
      if (result_ != bare) return;  // made anew, or of another finger
      if (*whole)
        result_ = std::make_shared<const FingerCalibration>(std::move(**whole));
      else
        recall_problem_ = whole->error();
      Q_EMIT changed();
    });
  });
}

CalibrationState CalibrationRun::state() const {
  if (!finger_ || !finger_->mapping || !from_) return CalibrationState::kNone;
  if (worth_ && worth_->must_repeat) return CalibrationState::kStale;
  if (!desk_.is_ready()) return CalibrationState::kCurrent;  // nobody could change anything yet
  const auto& presses = desk_.presses();
  const bool same_presses = std::equal(
      presses.begin(),
      presses.end(),
      from_->presses.begin(),
      from_->presses.end(),
      [](const DeskPress& press, const KeptPress& kept) { return press.name == kept.name; });
  return same_presses && input_for(desk_.said()).said == from_->said ? CalibrationState::kCurrent
                                                                     : CalibrationState::kStale;
}

FingerCalibrationInput CalibrationRun::input_for(const PressSet& said) const {
  FingerCalibrationInput input;
  input.folder = desk_.folder();
  input.presses.files = {desk_.folder() / kPressFolder};
  if (from_) {  // as this finger was calibrated last
    input.calibration = from_->calibration;
    input.pipeline = from_->pipeline;
  }
  std::set<std::string> presses;
  for (const DeskPress& press : desk_.presses()) presses.insert(press.name);
  input.said = said.only(presses);
  input.program_version = version_;
  return input;
}

QString CalibrationRun::command_line() const {
  FingerCalibrationInput input = input_for(desk_.said());
  if (state() == CalibrationState::kCurrent) {
    input = input_for(from_->said);
    input.date = from_->date;
  }
  return QString::fromStdString(calibrate_command(input));
}

CalibrationInputs CalibrationRun::next_inputs() const {
  const FingerCalibrationInput input = input_for(desk_.said());
  CalibrationInputs inputs;
  inputs.said = input.said;
  inputs.calibration = input.calibration;
  inputs.pipeline = input.pipeline;
  return inputs;
}

void CalibrationRun::take(const Made& made) {
  result_ = made.result;
  from_ = made.from;
  finger_ = made.finger;
  worth_ = made.worth;
  problem_.reset();
  recall_problem_.reset();
  // Undone to one whose presses were not read yet.
  lacks_residuals_ = result_ && result_->residuals.empty() && result_->presses.empty();
}

void CalibrationRun::start() {
  if (is_running()) return;
  report_.stop();
  FingerCalibrationInput input = input_for(desk_.said());
  input.date = utc_now();
  input.compare_methods = true;
  // Pictures that were not looked at yet are read from where they are kept.
  const auto& presses = desk_.presses();
  if (std::all_of(presses.begin(), presses.end(), [](const DeskPress& one) { return one.frame; }))
    for (const DeskPress& press : presses) input.presses.frames.push_back(press.frame);
  rounds_ = std::make_shared<HeardRounds>();
  input.on_round = [heard = rounds_](const Round& round) {
    const std::lock_guard lock(heard->mutex);
    heard->rounds.push_back(round);
  };
  struct Done {
    Files files;
    Made before;
    FingerPtr finger;
    std::optional<FingerWorth> worth;
    std::optional<Result<FingerCalibration>> result;
  };
  auto done = std::make_shared<Done>();
  done->before = {result_, from_, nullptr, worth_};
  work_.start([this, input, done, disk = desk_.disk()](const Job& job) {
    disk->wait();
    done->files = read_written(input.folder);
    if (const auto finger = open_finger(input.folder)) done->before.finger = *finger;
    done->result.emplace(calibrate_finger(input, job));
    if (const auto finger = open_finger(input.folder)) {
      done->finger = *finger;
      done->worth = worth_of(**finger, utc_now());
    }
    return std::function<void()>([this, done, folder = input.folder] {
      if (folder != desk_.folder()) return;
      if (!*done->result) {
        problem_ = done->result->error();
        return;
      }
      auto result = std::make_shared<const FingerCalibration>(std::move(**done->result));
      const Made after{result, result->inputs, done->finger, done->worth};
      take(after);
      has_report_ = false;
      undo_.push(new Undo(*this, std::move(done->files), done->before, after));
      report_.start(result, folder);
    });
  });
  Q_EMIT changed();
}

void CalibrationRun::stop() {
  work_.stop();
}

std::vector<Round> CalibrationRun::rounds() const {
  if (!rounds_) return {};
  const std::lock_guard lock(rounds_->mutex);
  return rounds_->rounds;
}

void CalibrationRun::restore(const Files& files, const Made& made) {
  take(made);
  has_report_ = files.at(kReportPage).has_value();
  desk_.disk()->add([folder = desk_.folder(), files, finger = made.finger]() -> Status {
    if (const Status written = write_written(folder, files); !written || !finger) return written;
    const auto changed = FingerStore::of(folder)->update([&](Finger& now) {
      take_calibration(finger->finger, now);
      return Status();
    });
    return changed ? Status() : changed.error();
  });
  if (loading_.is_running()) reload();  // which reads what there was before
  Q_EMIT changed();
}

fs::path CalibrationRun::report() const {
  return has_report_ && !is_writing_report() ? desk_.folder() / kReportPage : fs::path();
}

}  // namespace alltact
