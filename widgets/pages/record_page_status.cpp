// Status texts of the page Record: what is needed, progress and outcome.
#include "widgets/joined_words.h"
#include "widgets/pages/record_page.h"
#include "widgets/shell/icons.h"
#include "widgets/shell/primary_button.h"

namespace alltact {
namespace {

constexpr double kLittleSpace_gb = 2;
// Consecutive frames; the first ones of a source are always unknown.
constexpr int kMaxUnknownFrames = 15;

}  // namespace

QString RecordPage::time_text(double seconds) {
  const int total_s = static_cast<int>(seconds);
  return QStringLiteral("%1:%2").arg(total_s / 60).arg(total_s % 60, 2, 10, QLatin1Char('0'));
}

QString RecordPage::record_obstacle(const LiveStatus& status) const {
  if (is_installing()) return tr("The recording is being installed.");
  if (status.recording.state == RecordingState::kFinishing)
    return tr("The last frames are being written.");
  if (status.source.state != SourceState::kRunning)
    return tr("Open a source first: a camera, or the simulated finger.");
  return {};
}

void RecordPage::show_button(const LiveStatus& status) {
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const QString why = is_recording ? QString() : record_obstacle(status);
  record_->setText(is_recording ? tr("Stop &recording") : tr("Start &recording"));
  // setText() removes the shortcut.
  record_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  record_->setToolTip(tr("Ctrl+R, or Space"));
  record_->setIcon(
      icon(is_recording ? QStringLiteral("stop") : QStringLiteral("record"), palette()));
  record_->setEnabled(why.isEmpty());
  reason_->setText(why);
  reason_->setVisible(!why.isEmpty());
  for (QWidget* widget : {static_cast<QWidget*>(file_), static_cast<QWidget*>(browse_)})
    widget->setEnabled(!is_recording);
}

void RecordPage::show_progress(const RecordingStatus& recording) {
  const QLocale locale;
  const bool is_recording = recording.state == RecordingState::kRunning;
  progress_->setVisible(is_recording);
  const std::uint64_t lost = recording.counts.dropped + recording.counts.missing;
  if (is_recording)
    progress_->setText(
        tr("<b>Recording</b> %1 min<br>%2, %3, %4 GB")
            .arg(time_text(recording.seconds),
                 tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
                 tr("%n lost", nullptr, static_cast<int>(lost)),
                 locale.toString(static_cast<double>(recording.counts.bytes) / kGigabyte, 'f', 2)));
  std::optional<double> free_gb = free_gb_;
  if (is_recording && recording.counts.free_bytes > 0)
    free_gb = static_cast<double>(recording.counts.free_bytes) / kGigabyte;
  QStringList parts;
  if (free_gb) parts << tr("Space left: %1 GB").arg(locale.toString(*free_gb, 'f', 1));
  if (free_gb && is_recording && recording.seconds > 2 && recording.counts.bytes > 0) {
    const double gb_per_s =
        static_cast<double>(recording.counts.bytes) / kGigabyte / recording.seconds;
    parts << tr("room for about %n minute(s)",
                nullptr,
                static_cast<int>(std::min(*free_gb / gb_per_s / 60, 99999.0)));
  }
  space_->setText(joined(parts));
  space_->setVisible(!parts.isEmpty());
}

QString RecordPage::install_obstacle(const LiveStatus& status) const {
  if (status.finger.folder.empty()) return tr("Open the finger that was recorded first.");
  if (status.finger.finger && status.finger.finger->face.kind == FaceKind::kFlat)
    return tr("A flat sensor has one untouched picture instead of a recording.");
  if (is_busy()) return is_installing() ? QString() : tr("A recording is under way.");
  return {};
}

void RecordPage::mark_primary() {
  const bool is_offered = !recorded_.empty() && installed_ != recorded_;
  const bool is_refused = judge_.judged() && !judge_.judged()->report.ok();
  const bool installs = is_offered && install_->isEnabled() && !is_refused;
  const bool is_installed = !recorded_.empty() && report_ && report_->ok();
  set_primary(*install_, installs);
  set_primary(*again_, is_offered && is_refused && again_->isEnabled());
  set_primary(*onward_, is_installed && onward_->isEnabled());
  set_primary(*record_, !is_offered && !is_installed && !is_installing());
}

QString RecordPage::outcome_text() const {
  if (is_installing()) {
    const auto left = installing_work().seconds_left();
    if (!left) return tr("Reading the recording…");
    return tr("About %n second(s) left.", nullptr, static_cast<int>(*left) + 1);
  }
  if (!report_ || !report_->ok()) return {};
  const ReferenceReport& report = report_->value();
  QStringList lines{
      tr("Installed: %1 of %n frame(s) are in the reference.", nullptr, report.frames_read)
          .arg(report.frames_retained),
      tr("What it leaves open: half of the references made from it are off by less than %1 mm, 95 "
         "% "
         "by less than %2 mm.")
          .arg(QLocale().toString(report.error_median_mm, 'f', 3),
               QLocale().toString(report.error_p95_mm, 'f', 3))};
  if (report.repeated > 0)
    lines << tr("%n frame(s) showed a pose that others show as well.", nullptr, report.repeated);
  if (!session_.status().finger.has_reference)
    lines << tr("The finger is being read with its new reference.");
  if (!report.rejected.empty()) lines << tr("Left out, with the reason:");
  return lines.join(QLatin1Char('\n'));
}

void RecordPage::add_problems(std::vector<Problem>& problems) {
  const LiveStatus& status = session_.status();
  const FingerStatus& finger = status.finger;
  if (isVisible()) add_recording_problems(status, problems);
  if (finger.state != FingerState::kReady || finger.folder.empty()) return;
  if (finger.finger->face.kind == FaceKind::kFinRay && !finger.has_reference)
    problems.push_back({Meaning::kDoubtful,
                        tr("This finger has no reference recording yet."),
                        tr("Record it bending, with nothing on its contact face."),
                        {},
                        {}});
}

void RecordPage::add_recording_problems(const LiveStatus& status, std::vector<Problem>& problems) {
  if (status.recording.problem) problems.push_back(Problem::of(*status.recording.problem));
  if (report_ && !report_->ok()) problems.push_back(Problem::of(report_->error()));
  const auto note = [&](Meaning meaning, const QString& what, const QString& advice) {
    problems.push_back({meaning, what, advice, {}, {}});
  };
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const std::uint64_t lost =
      is_recording ? status.recording.counts.dropped + status.recording.counts.missing : 0;
  if (lost > 0)
    note(Meaning::kBad,
         tr("%n frame(s) of this recording are lost.", nullptr, static_cast<int>(lost)),
         tr("Try another disk, or a smaller picture."));
  add_contact_notes(status, problems);
  if (free_gb_ && *free_gb_ < kLittleSpace_gb)
    note(Meaning::kDoubtful,
         tr("Little space is left on the disk."),
         tr("Choose a file on another disk, or make room."));
  if (report_ && report_->ok())
    for (const Message& warning : report_->value().warnings)
      problems.push_back(Problem::of(Error{warning, "", ""}, Meaning::kDoubtful));
  if (!problem_image_.isNull())
    problems.push_back({Meaning::kDoubtful,
                        tr("A picture shows what was found in the recording, and what was not."),
                        {},
                        tr("Show the picture"),
                        [this] { show_problem_image(); }});
}

void RecordPage::add_contact_notes(const LiveStatus& status, std::vector<Problem>& problems) const {
  if (!session_.view()) return;
  if (is_in_contact_)
    problems.push_back({Meaning::kDoubtful,
                        tr("The contact face is touched; such frames are left out."),
                        tr("Keep it free: bend the finger at its tip, its sides or its back."),
                        {},
                        {}});
  if (unknown_frames_ >= kMaxUnknownFrames)
    problems.push_back({Meaning::kDoubtful,
                        tr("It cannot be seen whether the contact face is touched."),
                        tr("Open the finger that belongs to this source, and keep both edges of "
                           "its face in the picture."),
                        {},
                        {}});
  else if (!status.finger.has_reference && touch_ != FaceContact::kUnknown)
    problems.push_back({Meaning::kDoubtful,
                        tr("Before there is a reference, touching is told from the frames before."),
                        tr("Begin with nothing on the contact face."),
                        {},
                        {}});
}

}  // namespace alltact
