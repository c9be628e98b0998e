// What the place Record offers once there is a recording, and the ghost of the finger that shows
// which way to bend it meanwhile.
#include "calibration/reference/bend_ghost.h"
#include "core/sources/files/ending.h"
#include "widgets/language.h"
#include "widgets/picture/overlays.h"
#include "widgets/places/record_place.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QPainter>
#include <QPainterPath>
#include <QStandardPaths>
#include <cmath>

namespace alltact {
namespace {

constexpr int kGhost_ms = 2200;  // there, a moment of rest, and anew
constexpr double kGoing = 0.7;   // part of that
constexpr int kBetweenRig_ms = 300;
const QColor kGhost(255, 255, 255);

/// Eases in and out.
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
    write_beside(painter, QPointF(box.center().x() - 80, box.center().y() - 12), words, kGhost);
  };
}

}  // namespace

/// Of the first direction that is missing; none while nothing is to be followed.
std::vector<Overlay> RecordPlace::ghost(const LiveView& view) const {
  const BendPicture& picture = coverage_.picture();
  const auto missing = picture.missing();
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  const bool is_offered = !recorded_.empty() && !is_recording;
  if (missing.empty() || !picture.now || !view.result.shape || is_offered) return {};
  const double phase = static_cast<double>(ghost_clock_.elapsed() % kGhost_ms) / kGhost_ms / kGoing;
  const auto outline =
      bent_outline(*view.result.shape, part_of(motion_left(picture, missing.front()), ease(phase)));
  if (!outline) return {};
  return {ghost_overlay(*outline,
                        tr("Follow the outline: %1").arg(bend_direction_text(missing.front())))};
}

void RecordPlace::offer(const std::filesystem::path& video, std::optional<RestPose> rest_pose) {
  recorded_ = video;
  rest_pose_ = std::move(rest_pose);
  untouched_.clear();
  kept_.clear();
  skin_changed_->setChecked(false);
  judge_take();
}

void RecordPlace::judge_take() {
  const LiveStatus& status = session_.status();
  if (!recorded_.empty() && why_not_install(status).isEmpty())
    judge_.judge(status.finger.folder, recorded_, choices());
}

void RecordPlace::keep_take() {
  kept_ = std::exchange(recorded_, {});
  judge_.forget();
  report_.reset();
  show_status();
}

void RecordPlace::record_again() {
  const auto video = std::exchange(recorded_, {});
  judge_.forget();
  // The bin lies there; where that is missing, Qt 6.4 makes one in whatever folder is the current.
  QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
  // Only what was recorded just now, and not what was installed: that has been copied.
  if (video == session_.status().recording.file)
    for (const auto& file : {video, std::filesystem::path(video).replace_extension(".frames.csv")})
      QFile::moveToTrash(QString::fromStdString(file.string()));
  begin_recording();
}

void RecordPlace::choose_video() {
  auto* dialog = new QFileDialog(this,
                                 tr("Video of the bending finger"),
                                 QString::fromStdString(session_.status().finger.folder.string()),
                                 tr("Videos (*.mkv *.avi *.mp4 *.mov)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    report_.reset();
    problem_picture_ = {};
    offer(file.toStdString(), std::nullopt);
    show_status();
  });
  dialog->show();
}

QString RecordPlace::take_words(const RecordingStatus& recording) const {
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
  if (touched_frames_ > 0)
    lines << tr(
        "Touched in %n frame(s), which are left out.", nullptr, static_cast<int>(touched_frames_));
  return lines.join(QLatin1Char('\n'));
}

QString RecordPlace::judged_words() const {
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
            report.frames_kept)
      .arg(QLocale().toString(report.error_median_mm, 'f', 3),
           QLocale().toString(report.error_p95_mm, 'f', 3));
}

void RecordPlace::show_offer(const LiveStatus& status) {
  const QString why = why_not_install(status);
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

void RecordPlace::show_recorded(const LiveStatus& status) {
  const bool is_kept = !kept_.empty();
  result_group_->setVisible(!recorded_.empty() || is_kept);
  if (recorded_.empty() && !is_kept) return;
  if (is_kept) {
    summary_->setText(tr("Kept: %1").arg(QString::fromStdString(kept_.filename().string())));
    summary_->setToolTip(QString::fromStdString(kept_.string()));
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

/// The list before the first recording.
void RecordPlace::show_rig() {
  const LiveStatus& status = session_.status();
  const bool is_recording = status.recording.state == RecordingState::kRunning;
  const auto& finger = status.finger.finger;
  const bool is_own = finger && status.finger.state == FingerState::kReady;
  rig_box_->setVisible(is_own && session_.view() && !is_recording &&
                       finger->face.kind == FaceKind::kFinRay);
  rig_box_->set_needed(is_own && !status.finger.has_reference && recorded_.empty());
  if (!is_own || !isVisible()) return;
  if (since_rig_.isValid() && since_rig_.elapsed() < kBetweenRig_ms) return;
  since_rig_.start();
  rig_box_->show_findings(rig_.findings(2 * finger->markers.per_row), status.controller.controls);
}

}  // namespace alltact
