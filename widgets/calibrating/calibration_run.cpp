#include "widgets/calibrating/calibration_run.h"

#include "calibration/finger/calibration_report.h"
#include "core/io/atomic_file.h"
#include "core/utc_time.h"

#include <QUndoCommand>
#include <algorithm>
#include <mutex>
#include <set>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPage = "calibration_report.html";
/// All that a calibration writes beside the presses, what tells of the finger last.
constexpr const char* kWritten[] = {CalibrationInputs::kFileName,
                                    "calibration_report.json",
                                    kPage,
                                    "calibration_report.pdf",
                                    Finger::kFileName};

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

bool say_the_same(const PressNotes& a, const PressNotes& b) {
  return a.operator_name == b.operator_name && a.by_name() == b.by_name();
}

}  // namespace

/// Told on one thread, shown on another.
struct CalibrationRun::HeardRounds {
  std::mutex mutex;
  std::vector<Round> rounds;
};

/// A calibration as a step: what was written before it is put back.
class CalibrationRun::Undo : public QUndoCommand {
 public:
  Undo(CalibrationRun& run, Files before, Made made_before, Made made_after)
      : QUndoCommand(tr("calibrate")),
        run_(run),
        folder_(run.desk_.folder()),
        before_(std::move(before)),
        made_before_(std::move(made_before)),
        made_after_(std::move(made_after)) {}

  void undo() override {
    if (run_.desk_.folder() != folder_) return;
    run_.end_report();
    run_.desk_.disk()->wait();
    after_ = read_written(folder_);
    run_.restore(before_, made_before_);
  }
  void redo() override {
    if (after_.empty() || run_.desk_.folder() != folder_) return;  // the first time it is done
    run_.end_report();
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
                               fs::path program,
                               QObject* parent)
    : QObject(parent),
      desk_(desk),
      undo_(undo),
      version_(std::move(program_version)),
      program_(std::move(program)) {
  connect(&work_, &BackgroundWork::progressed, this, &CalibrationRun::changed);
  connect(&work_, &BackgroundWork::finished, this, &CalibrationRun::changed);
  connect(&writing_, &BackgroundWork::finished, this, [this] {
    if (told_ != restored_) tell_when_written();
  });
  connect(&process_, &QProcess::finished, this, [this](int status) {
    has_report_ = status == 0;
    if (!has_report_) report_errors_ = QString::fromUtf8(process_.readAllStandardError().trimmed());
    Q_EMIT changed();
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) start_problem_ = process_.errorString();
    Q_EMIT changed();
  });
}

CalibrationRun::~CalibrationRun() {
  end_report();
}

void CalibrationRun::reload() {
  const fs::path folder = desk_.folder();
  if (folder != looked_at_) {
    end_report();
    result_.reset();
    from_.reset();
    finger_.reset();
    problem_.reset();
    looked_at_ = folder;
  }
  if (folder.empty()) return void(Q_EMIT changed());
  loading_.start([this, folder](const Job&) {
    auto inputs = std::make_shared<Result<CalibrationInputs>>(CalibrationInputs::load(folder));
    auto finger = std::make_shared<Result<Finger>>(Finger::load(folder));
    std::error_code failed;
    const bool has_report = fs::exists(folder / kPage, failed);
    return std::function<void()>([this, folder, inputs, finger, has_report] {
      if (folder != desk_.folder()) return reload();
      if (*inputs) from_ = **inputs;
      if (*finger) finger_ = std::make_shared<const Finger>(**finger);
      if (!is_writing_report()) has_report_ = has_report;
      Q_EMIT changed();
    });
  });
}

CalibrationState CalibrationRun::state() const {
  if (!finger_ || !finger_->mapping || !from_) return CalibrationState::kNone;
  const auto& presses = desk_.presses();
  const bool same_presses = std::equal(
      presses.begin(),
      presses.end(),
      from_->presses.begin(),
      from_->presses.end(),
      [](const DeskPress& press, const KeptPress& kept) { return press.name == kept.name; });
  return same_presses && say_the_same(desk_.notes(), PressNotes::of(*from_))
             ? CalibrationState::kCurrent
             : CalibrationState::kStale;
}

FingerCalibrationInput CalibrationRun::input_for(const PressNotes& notes) const {
  FingerCalibrationInput input;
  input.folder = desk_.folder();
  input.presses = {desk_.folder() / kPressFolder};
  if (from_) {  // as this finger was calibrated last
    input.calibration = from_->calibration;
    input.pipeline = from_->pipeline;
  }
  std::set<std::string> presses;
  for (const DeskPress& press : desk_.presses()) presses.insert(press.name);
  static_cast<SaidOfPresses&>(input) = notes.only(presses);
  input.operator_name = notes.operator_name;
  input.program_version = version_;
  return input;
}

QString CalibrationRun::command_line() const {
  FingerCalibrationInput input = input_for(desk_.notes());
  if (state() == CalibrationState::kCurrent) {
    input = input_for(PressNotes::of(*from_));
    input.date = from_->date;
  }
  return QString::fromStdString(calibrate_command(input));
}

void CalibrationRun::take(const Made& made) {
  result_ = made.result;
  from_ = made.from;
  finger_ = made.finger;
  problem_.reset();
}

void CalibrationRun::start() {
  if (is_running()) return;
  end_report();
  start_problem_.clear();
  report_errors_.clear();
  FingerCalibrationInput input = input_for(desk_.notes());
  input.date = utc_now();
  rounds_ = std::make_shared<HeardRounds>();
  input.on_round = [heard = rounds_](const Round& round) {
    const std::lock_guard lock(heard->mutex);
    heard->rounds.push_back(round);
  };
  struct Done {
    Files before;
    std::optional<Result<FingerCalibration>> result;
  };
  work_.start([this, input, disk = desk_.disk()](const Job& job) {
    auto done = std::make_shared<Done>();
    disk->wait();
    done->before = read_written(input.folder);
    done->result.emplace(calibrate_finger(input, job));
    return std::function<void()>([this, done, folder = input.folder] {
      if (folder != desk_.folder()) return;
      if (!*done->result) {
        problem_ = done->result->error();
        return;
      }
      const Made before{result_, from_, finger_};
      auto result = std::make_shared<const FingerCalibration>(std::move(**done->result));
      const Made after{result, result->inputs, std::make_shared<const Finger>(result->finger)};
      take(after);
      has_report_ = false;
      undo_.push(new Undo(*this, std::move(done->before), before, after));
      write_report();
      Q_EMIT finger_changed();
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

QString CalibrationRun::report_problem() const {
  if (is_program_missing_)
    return tr("The command line, alltact, is not installed beside this program.");
  return report_errors_.isEmpty() ? start_problem_ : report_errors_;
}

void CalibrationRun::write_report() {
  is_program_missing_ = program_.empty();
  if (is_program_missing_) return;
  process_.start(QString::fromStdString(program_.string()),
                 {QStringLiteral("calibrate"),
                  QString::fromStdString(desk_.folder().string()),
                  QStringLiteral("--again")});
}

void CalibrationRun::end_report() {
  if (!is_writing_report()) return;
  const QSignalBlocker quiet(process_);
  process_.kill();
  process_.waitForFinished(500);
}

void CalibrationRun::restore(const Files& files, const Made& made) {
  take(made);
  has_report_ = files.at(kPage).has_value();
  ++restored_;
  desk_.disk()->add([folder = desk_.folder(), files] { return write_written(folder, files); });
  tell_when_written();
  Q_EMIT changed();
}

void CalibrationRun::tell_when_written() {
  if (writing_.is_running()) return;  // asks again when it is done
  writing_.start([this, disk = desk_.disk(), seen = restored_](const Job&) {
    disk->wait();
    return std::function<void()>([this, seen] {
      told_ = seen;
      if (seen == restored_) Q_EMIT finger_changed();
    });
  });
}

fs::path CalibrationRun::report() const {
  return has_report_ && !is_writing_report() ? desk_.folder() / kPage : fs::path();
}

}  // namespace alltact
