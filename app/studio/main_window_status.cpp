// What the window tells of what runs: header, status line, problems.
#include "app/studio/main_window.h"
#include "calibration/reference/settings_record.h"
#include "core/sources/open/open_source.h"
#include "widgets/accessible.h"
#include "widgets/language.h"

#include <QLocale>

namespace alltact {
namespace {

QString name_of_finger(const FingerStatus& finger) {
  if (finger.finger && !finger.finger->name.empty())
    return QString::fromStdString(finger.finger->name);
  return QString::fromStdString(finger.folder.filename().string());
}

}  // namespace

void MainWindow::follow() {
  const LiveStatus& status = session_.status();
  show_header(status);
  show_line(status);
  show_undo();
  problems_->set_problems(problems_of(status));
}

void MainWindow::show_header(const LiveStatus& status) {
  QString finger = name_of_finger(status.finger);
  if (status.finger.state == FingerState::kNone) finger = tr("none", "finger");
  if (status.finger.state == FingerState::kLoading) finger = tr("%1 (loading)").arg(finger);
  if (status.finger.state == FingerState::kReady && status.finger.folder.empty())
    finger = tr("%1 (simulated)").arg(finger);
  finger_button_->setText(finger);
  finger_button_->setAccessibleName(tr("Finger: %1").arg(finger));
  finger_button_->setToolTip(QString::fromStdString(status.finger.folder.string()));
  const QString source = source_name();
  source_button_->setText(source);
  source_button_->setAccessibleName(tr("Source: %1").arg(source));
  if (!state_.source.empty())
    source_button_->setToolTip(QString::fromStdString(state_.source.front().string()));
}

void MainWindow::show_line(const LiveStatus& status) {
  const QLocale locale;
  const bool is_open = session_.view() != nullptr;
  for (QLabel* label : {delivered_, lost_, age_, time_}) label->setVisible(is_open);
  if (!is_open) return;
  const SourceStatus& source = status.source;
  delivered_->setText(tr("%1 frames/s, %2 delivered, %3 shown a second")
                          .arg(locale.toString(source.frames_per_s, 'f', 1),
                               locale.toString(static_cast<qulonglong>(source.delivered)),
                               locale.toString(status.shown_per_s, 'f', 1)));
  const std::uint64_t damaged = source.camera ? source.camera->counts.damaged : 0;
  const int lost = static_cast<int>(source.missing + damaged);
  lost_->setText(tr("%n frame(s) lost", nullptr, lost));
  age_->setText(status.age_ms ? tr("picture %1 ms old").arg(locale.toString(*status.age_ms, 'f', 0))
                              : tr("pictures without times"));
  const auto& view = session_.view();
  time_->setText(view ? tr("%1 ms a frame").arg(locale.toString(session_.times_ms().total, 'f', 1))
                      : QString());
}

std::vector<Problem> MainWindow::problems_of(const LiveStatus& status) {
  std::vector<Problem> problems;
  if (keeper_.has_crashed() && !is_crash_told_) {
    Problem crash{Meaning::kDoubtful,
                  tr("The program ended unexpectedly last time."),
                  tr("What was worked on is kept."),
                  tr("&Go on with it"),
                  [this] { go_on_with_last(); }};
    problems.push_back(std::move(crash));
  }
  if (const auto kept = keeper_.problem())
    problems.push_back(Problem::of(*kept, Meaning::kDoubtful));
  if (const auto& away = pedal_.problem())
    problems.push_back({Meaning::kDoubtful,
                        tr("The foot pedal is not heard now."),
                        window_sentence(away->message()),
                        {},
                        {}});
  add_source_problems(status, problems);
  add_finger_problems(status, problems);
  return problems;
}

void MainWindow::add_source_problems(const LiveStatus& status,
                                     std::vector<Problem>& problems) const {
  const SourceStatus& source = status.source;
  if (source.problem) problems.push_back(Problem::of(*source.problem));
  if (source.state == SourceState::kEnded) {
    Problem ended{
        Meaning::kDoubtful,
        tr("The source has ended; its last picture is shown."),
        {},
        tr("&Play it again"),
        [this, inputs = state_.source] { const_cast<MainWindow*>(this)->open_source(inputs); }};
    problems.push_back(std::move(ended));
  }
  if (status.desk.problem) problems.push_back(Problem::of(*status.desk.problem));
  if (!status.remark.empty())
    problems.push_back(Problem::of(Error{status.remark, "", ""}, Meaning::kDoubtful));
}

void MainWindow::add_finger_problems(const LiveStatus& status,
                                     std::vector<Problem>& problems) const {
  const FingerStatus& finger = status.finger;
  if (finger.problem) problems.push_back(Problem::of(*finger.problem));
  for (const Message& warning : finger.warnings)
    problems.push_back(Problem::of(Error{warning, "", ""}, Meaning::kDoubtful));
  const auto& view = session_.view();
  if (view && view->watched.problem) problems.push_back(Problem::of(*view->watched.problem));
  if (view && finger.finger && finger.has_reference && view->watched.result.frame) {
    const Message other = other_settings_than_stored(*view->watched.result.frame, *finger.finger);
    if (!other.empty()) problems.push_back(Problem::of(Error{other, "", ""}, Meaning::kDoubtful));
  }
  const bool is_own = finger.state == FingerState::kReady && !finger.folder.empty();
  if (is_own && finger.finger->face.kind == FaceKind::kFinRay && !finger.has_reference)
    problems.push_back({Meaning::kDoubtful,
                        tr("This finger has no reference recording yet."),
                        tr("Record it bending, with nothing on its contact face."),
                        {},
                        {}});
  else if (is_own && !finger.finger->mapping)
    problems.push_back({Meaning::kDoubtful,
                        tr("This finger is not calibrated yet, so that no depth is shown."),
                        tr("Calibrate it with ball presses."),
                        state_.place == "calibrate" ? QString() : tr("&Go to Calibrate"),
                        [this] { const_cast<MainWindow*>(this)->go_to("calibrate"); }});
}

}  // namespace alltact
