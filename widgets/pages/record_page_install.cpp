// Installation of a recording in the page Record, and its outcome.
#include "widgets/language.h"
#include "widgets/pages/record_page.h"
#include "widgets/shell/image_dialog.h"

#include <QPoint>
#include <QSignalBlocker>
#include <set>

namespace alltact {
namespace {

/// Reuses the judged result of the same recording.
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

bool RecordPage::is_installing() const {
  return install_work_.is_running() || install_after_judging_;
}

void RecordPage::install() {
  report_.reset();
  problem_image_ = {};
  install_after_judging_ = judge_.is_working();
  if (!install_after_judging_) install_now();
  show_status();
}

void RecordPage::follow_judge() {
  if (install_after_judging_ && !judge_.is_working()) {
    install_after_judging_ = false;
    // An error is shown already by the judging.
    if (judge_.judged() && judge_.judged()->report.ok()) install_now();
  }
  if (install_after_judging_) show_installing();
  show_status();
}

ReferenceChoices RecordPage::choices() const {
  ReferenceChoices choices;
  choices.rest_pose = rest_pose_;
  choices.keep = contact_free_;
  choices.skin_was_changed = skin_changed_->isChecked();
  return choices;
}

void RecordPage::install_now() {
  const auto folder = session_.status().finger.folder;
  const auto video = recorded_;
  const auto judged = contact_free_.empty() ? judge_.judged() : nullptr;
  install_work_.start(
      [this, folder, video, choices = choices(), judged, installer = installer_](const Job& job) {
        auto report = std::make_shared<Result<ReferenceReport>>(
            install_take(installer, judged, folder, video, choices, job));
        const QImage image(QString::fromStdString((folder / kReferenceProblem).string()));
        // A stop by the user needs no error message.
        const bool is_stopped = job.stop_requested() && !report->ok();
        return std::function<void()>([this, report, video, image, is_stopped] {
          if (is_stopped) return;
          installed_ = video;
          report_ = *report;
          problem_image_ = image;
          if (report->ok()) judge_.forget();
          list_rejected();
        });
      });
}

void RecordPage::stop_installing() {
  install_after_judging_ = false;
  install_work_.stop();
  show_status();
}

void RecordPage::show_installing() {
  bar_->setValue(static_cast<int>(100 * installing_work().fraction()));
  outcome_->setText(outcome_text());
  outcome_->setVisible(true);
}

const BackgroundWork& RecordPage::installing_work() const {
  return install_after_judging_ ? judge_.work() : install_work_;
}

void RecordPage::show_problem_image() {
  auto* dialog = new ImageDialog(problem_image_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("What was found in the recording"));
  dialog->show();
}

void RecordPage::list_rejected() {
  const QSignalBlocker no_choice(rejected_);
  rejected_->clear();
  if (!report_ || !*report_) return;
  std::set<std::string> listed;
  for (const ReferenceStretch& stretch : report_->value().stretches) {
    auto* item = new QListWidgetItem(in_window_language(stretch.sentence), rejected_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(stretch.is_retained ? Qt::Checked : Qt::Unchecked);
    item->setData(Qt::UserRole, QPoint(stretch.first, stretch.last));
    listed.insert(stretch.sentence.english());
  }
  for (const Message& reason : report_->value().rejected)
    if (!listed.contains(reason.english())) rejected_->addItem(in_window_language(reason));
}

void RecordPage::choose_frames() {
  contact_free_.clear();
  for (int row = 0; row < rejected_->count(); ++row) {
    const QListWidgetItem& item = *rejected_->item(row);
    const QPoint frames = item.data(Qt::UserRole).toPoint();
    const bool is_stretch = (item.flags() & Qt::ItemIsUserCheckable) != 0;
    if (is_stretch && item.checkState() == Qt::Checked)
      contact_free_.push_back({frames.x(), frames.y()});
  }
  installed_.clear();  // the choice differs from what is installed
  show_status();
}

}  // namespace alltact
