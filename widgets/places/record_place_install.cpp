// How the place Record installs what was recorded, and what came of it.
#include "widgets/language.h"
#include "widgets/places/record_place.h"
#include "widgets/shell/picture_dialog.h"

#include <QPoint>
#include <QSignalBlocker>
#include <set>

namespace alltact {
namespace {

/// What was worked out to judge the recording is not worked out again.
Result<ReferenceReport> install_take(const ReferenceInstaller& installer,
                                     const std::shared_ptr<const JudgedTake>& judged,
                                     const std::filesystem::path& folder,
                                     const std::filesystem::path& video,
                                     const ReferenceChoices& choices,
                                     const Job& job) {
  if (judged && judged->finger == folder && judged->video == video) {
    const auto is_done = judged->install();
    if (!is_done) return is_done.error();
    if (*is_done) return judged->report;
  }
  return installer(folder, video, choices, job);
}

}  // namespace

bool RecordPlace::is_installing() const {
  return install_work_.is_running() || installs_when_judged_;
}

void RecordPlace::install() {
  report_.reset();
  problem_picture_ = {};
  installs_when_judged_ = judge_.is_working();
  if (!installs_when_judged_) install_now();
  show_status();
}

void RecordPlace::follow_judge() {
  if (installs_when_judged_ && !judge_.is_working()) {
    installs_when_judged_ = false;
    // What cannot be installed is said already.
    if (judge_.judged() && judge_.judged()->report.ok()) install_now();
  }
  if (installs_when_judged_) show_installing();
  show_status();
}

ReferenceChoices RecordPlace::choices() const {
  ReferenceChoices choices;
  choices.rest_pose = rest_pose_;
  choices.keep = untouched_;
  choices.skin_was_changed = skin_changed_->isChecked();
  return choices;
}

void RecordPlace::install_now() {
  const auto folder = session_.status().finger.folder;
  const auto video = recorded_;
  const auto judged = untouched_.empty() ? judge_.judged() : nullptr;
  install_work_.start(
      [this, folder, video, choices = choices(), judged, installer = installer_](const Job& job) {
        auto report = std::make_shared<Result<ReferenceReport>>(
            install_take(installer, judged, folder, video, choices, job));
        const QImage picture(QString::fromStdString((folder / kReferenceProblem).string()));
        // Who stopped it knows why nothing was installed.
        const bool is_stopped = job.stop_requested() && !report->ok();
        return std::function<void()>([this, report, video, picture, is_stopped] {
          if (is_stopped) return;
          installed_ = video;
          report_ = *report;
          problem_picture_ = picture;
          if (report->ok()) judge_.forget();
          list_rejected();
        });
      });
}

void RecordPlace::stop_installing() {
  installs_when_judged_ = false;
  install_work_.stop();
  show_status();
}

void RecordPlace::show_installing() {
  bar_->setValue(static_cast<int>(100 * installing_work().fraction()));
  outcome_->setText(outcome_text());
  outcome_->setVisible(true);
}

const BackgroundWork& RecordPlace::installing_work() const {
  return installs_when_judged_ ? judge_.work() : install_work_;
}

void RecordPlace::show_problem_picture() {
  auto* dialog = new PictureDialog(problem_picture_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("What was found in the recording"));
  dialog->show();
}

void RecordPlace::list_rejected() {
  const QSignalBlocker no_choice(rejected_);
  rejected_->clear();
  if (!report_ || !*report_) return;
  std::set<std::string> listed;
  for (const ReferenceStretch& stretch : report_->value().stretches) {
    auto* item = new QListWidgetItem(in_window_language(stretch.sentence), rejected_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(stretch.is_kept ? Qt::Checked : Qt::Unchecked);
    item->setData(Qt::UserRole, QPoint(stretch.first, stretch.last));
    listed.insert(stretch.sentence.english());
  }
  for (const Message& reason : report_->value().rejected)
    if (!listed.contains(reason.english())) rejected_->addItem(in_window_language(reason));
}

void RecordPlace::choose_frames() {
  untouched_.clear();
  for (int row = 0; row < rejected_->count(); ++row) {
    const QListWidgetItem& item = *rejected_->item(row);
    const QPoint frames = item.data(Qt::UserRole).toPoint();
    const bool is_stretch = (item.flags() & Qt::ItemIsUserCheckable) != 0;
    if (is_stretch && item.checkState() == Qt::Checked)
      untouched_.push_back({frames.x(), frames.y()});
  }
  installed_.clear();  // what is installed is not what is chosen now
  show_status();
}

}  // namespace alltact
