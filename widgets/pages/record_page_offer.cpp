// The page Record after a recording: installation, and the ghost outline that shows how to bend the
// finger.
#include "calibration/reference/bend_ghost.h"
#include "core/sources/files/file_extension.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/pages/record_page.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QPainter>
#include <QPainterPath>
#include <QStandardPaths>
#include <cmath>

namespace alltact {
namespace {

constexpr int kGhostPeriod_ms = 2200;    // one period: motion, a rest, and a restart
constexpr double kMotionFraction = 0.7;  // fraction of the period
constexpr int kRigInterval_ms = 300;
const QColor kGhost(255, 255, 255);

/// Smoothstep from 0 to 1.
double ease(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

TipMotion part_of(const TipMotion& motion, double part) {
  return {part * motion.bend_mm, part * motion.sway_mm, part * motion.twist_deg};
}

Overlay ghost_overlay(const BentOutline& outline, const QString& words) {
  return [outline, words](QPainter& painter, const ImageTransform& transform) {
    QPolygonF polygon;
    for (const auto& p : outline.upper) polygon << transform.to_widget({p.x(), p.y()});
    for (auto p = outline.lower.rbegin(); p != outline.lower.rend(); ++p)
      polygon << transform.to_widget({p->x(), p->y()});
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    QColor inside = kGhost;
    inside.setAlpha(45);
    painter.fillPath(path, inside);
    stroke_over(painter, path, kGhost, 2, Qt::DashLine);
    const QRectF box = path.boundingRect();
    write_next_to(painter, QPointF(box.center().x() - 80, box.center().y() - 12), words, kGhost);
  };
}

}  // namespace

/// Ghost of the first missing direction; none where there is nothing to follow.
std::vector<Overlay> RecordPage::ghost(const LiveView& view) const {
  const BendState& covered = coverage_.state();
  const auto missing = covered.missing();
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  const bool is_offered = !recorded_.empty() && !is_recording;
  if (missing.empty() || !covered.now || !view.result.shape || is_offered) return {};
  const double phase = static_cast<double>(ghost_clock_.elapsed() % kGhostPeriod_ms) /
                       kGhostPeriod_ms / kMotionFraction;
  const auto outline =
      bent_outline(*view.result.shape, part_of(motion_left(covered, missing.front()), ease(phase)));
  if (!outline) return {};
  return {ghost_overlay(*outline,
                        tr("Follow the outline: %1").arg(bend_direction_text(missing.front())))};
}

void RecordPage::offer(const std::filesystem::path& video, std::optional<RestPose> rest_pose) {
  recorded_ = video;
  rest_pose_ = std::move(rest_pose);
  contact_free_.clear();
  deferred_.clear();
  skin_changed_->setChecked(false);
  judge_take();
}

void RecordPage::judge_take() {
  const LiveStatus& status = session_.status();
  if (!recorded_.empty() && install_obstacle(status).isEmpty())
    judge_.judge(status.finger.folder, recorded_, choices());
}

void RecordPage::defer_take() {
  deferred_ = std::exchange(recorded_, {});
  judge_.forget();
  report_.reset();
  show_status();
}

void RecordPage::record_again() {
  const auto video = std::exchange(recorded_, {});
  judge_.forget();
  // The trash is in this folder; without it, Qt 6.4 creates one in the current folder.
  QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
  // Only the last recording is removed; an installed video has been copied.
  if (video == session_.status().recording.file)
    for (const auto& file : {video, std::filesystem::path(video).replace_extension(".frames.csv")})
      QFile::moveToTrash(QString::fromStdString(file.string()));
  begin_recording();
}

void RecordPage::choose_video() {
  auto* dialog = new QFileDialog(this,
                                 tr("Video of the bending finger"),
                                 QString::fromStdString(session_.status().finger.folder.string()),
                                 tr("Videos (*.mkv *.avi *.mp4 *.mov)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    report_.reset();
    problem_image_ = {};
    offer(file.toStdString(), std::nullopt);
    show_status();
  });
  dialog->show();
}

QString RecordPage::take_words(const RecordingStatus& recording) const {
  const QString name = QString::fromStdString(recorded_.filename().string());
  if (recording.file != recorded_) return name;
  QStringList lines{
      tr("%1: %2, %3 min")
          .arg(name,
               tr("%n frame(s)", nullptr, static_cast<int>(recording.counts.recorded)),
               time_text(recording.seconds))};
  if (const auto dropped = recording.counts.dropped; dropped > 0)
    lines << tr("%n frame(s) were lost because this computer or its disk was too slow.",
                nullptr,
                static_cast<int>(dropped));
  if (const auto missing = recording.counts.missing; missing > 0)
    lines << tr("%n frame(s) never came from the source.", nullptr, static_cast<int>(missing));
  if (recording.counts.dropped + recording.counts.missing == 0) lines << tr("No frame was lost.");
  if (contact_frames_ > 0)
    lines << tr(
        "Touched in %n frame(s), which are left out.", nullptr, static_cast<int>(contact_frames_));
  return lines.join(QLatin1Char('\n'));
}

QString RecordPage::judged_words() const {
  if (judge_.is_working()) {
    const auto left = judge_.work().seconds_left();
    return left ? tr("What it would bring is being worked out, about %n second(s).",
                     nullptr,
                     static_cast<int>(*left) + 1)
                : tr("What it would bring is being worked out.");
  }
  if (!judge_.judged() || report_) return {};
  const Result<ReferenceReport>& judged = judge_.judged()->report;
  if (!judged.ok())
    return tr("It cannot be installed: %1").arg(window_sentence(judged.error().what));
  const ReferenceReport& report = judged.value();
  return tr("It would bring: half of the references off by less than %1 mm, 95 % by less than %2 "
            "mm, from %n frame(s).",
            nullptr,
            report.frames_retained)
      .arg(QLocale().toString(report.error_median_mm, 'f', 3),
           QLocale().toString(report.error_p95_mm, 'f', 3));
}

void RecordPage::show_offer(const LiveStatus& status) {
  const QString why = install_obstacle(status);
  const bool is_installed = report_ && report_->ok() && installed_ == recorded_;
  install_->setEnabled(why.isEmpty() && !is_installing());
  install_->setVisible(!is_installing() && !is_installed);
  for (QPushButton* other : {keep_, again_}) {
    other->setEnabled(!is_installing() && status.recording.state != RecordingState::kFinishing);
    other->setVisible(!is_installing() && !is_installed);
  }
  again_->setEnabled(again_->isEnabled() && record_->isEnabled());
  onward_->setVisible(is_installed && !is_installing());
  onward_->setEnabled(status.finger.has_reference);
  install_reason_->setText(why);
  install_reason_->setVisible(!why.isEmpty());
  skin_changed_->setVisible(status.finger.has_reference && !is_installing() && !is_installed);
  judged_->setText(judged_words());
  judged_->setVisible(!judged_->text().isEmpty() && !is_installing());
  bar_->setVisible(is_installing());
  stop_install_->setVisible(is_installing());
}

void RecordPage::show_recorded(const LiveStatus& status) {
  const bool is_deferred = !deferred_.empty();
  result_group_->setVisible(!recorded_.empty() || is_deferred);
  if (recorded_.empty() && !is_deferred) return;
  if (is_deferred) {
    summary_->setText(tr("Kept: %1").arg(QString::fromStdString(deferred_.filename().string())));
    summary_->setToolTip(QString::fromStdString(deferred_.string()));
    for (QWidget* widget : {static_cast<QWidget*>(install_),
                            static_cast<QWidget*>(keep_),
                            static_cast<QWidget*>(again_),
                            static_cast<QWidget*>(onward_),
                            static_cast<QWidget*>(install_reason_),
                            static_cast<QWidget*>(judged_),
                            static_cast<QWidget*>(skin_changed_),
                            static_cast<QWidget*>(bar_),
                            static_cast<QWidget*>(stop_install_),
                            static_cast<QWidget*>(outcome_),
                            static_cast<QWidget*>(rejected_)})
      widget->hide();
    return;
  }
  summary_->setText(take_words(status.recording));
  summary_->setToolTip(QString::fromStdString(recorded_.string()));
  show_offer(status);
  outcome_->setText(outcome_text());
  outcome_->setVisible(!outcome_->text().isEmpty());
  rejected_->setVisible(report_ && report_->ok() && rejected_->count() > 0 && !is_installing());
}

/// The checklist before the first recording.
void RecordPage::show_rig() {
  const LiveStatus& status = session_.status();
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const auto& finger = status.finger.finger;
  const bool has_folder = finger && status.finger.state == FingerState::kReady;
  rig_box_->setVisible(has_folder && session_.view() && !is_recording &&
                       finger->face.kind == FaceKind::kFinRay);
  rig_box_->set_needed(has_folder && !status.finger.has_reference && recorded_.empty());
  if (!has_folder || !isVisible()) return;
  if (since_rig_.isValid() && since_rig_.elapsed() < kRigInterval_ms) return;
  since_rig_.start();
  rig_box_->show_findings(rig_.findings(2 * finger->markers.per_row), status.controller.controls);
}

}  // namespace alltact
