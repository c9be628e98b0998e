// Views and texts of the page Inspect for a frame, and without one.
#include "widgets/inspect/face_positions.h"
#include "widgets/inspect/reading_text.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/shell/elided_label.h"

namespace alltact {

void InspectPage::show_frame() {
  const auto& frame = inspection_.frame();
  if (frame && !options_.recording.empty()) {
    last_frame_[options_.recording] = frame->number;
    if (!time_line_->is_playing()) Q_EMIT changed();
  }
  pair_.follow();
  show_panes();
  side_->show_frame(frame && frame->surface ? frame : nullptr);
  follow_contact();
  summary_->setText(summary_text());
  show_probe();
  if (live_film_) live_film_->add(film_moment());
  show_state();
}

void InspectPage::show_summaries() {
  const auto& recording = inspection_.recording();
  if (recording) time_line_->set_recording(recording->count, recording->frames_per_s);
  time_line_->set_summaries(inspection_.summaries());
}

QString InspectPage::summary_text() const {
  const auto text = [](const std::shared_ptr<const InspectedFrame>& frame) {
    return frame && frame->surface ? deepest_text(*frame) : QString();
  };
  const QString first = text(inspection_.frame());
  if (!options_.second) return first;
  return QStringLiteral("1: ") + first + QStringLiteral("   2: ") + text(pair_.second().frame());
}

QString InspectPage::title_of(bool is_second) const {
  if (!options_.second) {
    const QString other = comparand_text(options_.with);
    if (is_second) return tr("Compared with: %1").arg(other);
    const Comparison comparison = options_.shown_comparison();
    return comparison == Comparison::kSideBySide   ? tr("Shown")
           : comparison == Comparison::kDifference ? tr("Shown less: %1").arg(other)
           : inspection_.frame() && inspection_.frame()->bare
               ? tr("Not calibrated yet: the shape of the whole finger, without depth")
               : QString();
  }
  if (is_joint_view())
    return tr("1: %1, 2: %2, in the gripper's frame X, Y, Z")
        .arg(pair_.name(false), pair_.name(true));
  return (is_second ? QStringLiteral("2: ") : QStringLiteral("1: ")) + pair_.name(is_second);
}

void InspectPage::show_panes() {
  const auto& frame = inspection_.frame();
  const bool has_face = frame && frame->surface;
  const bool is_pair = is_joint_view() && pair_.frames();
  first_->set_title(title_of(false));
  second_->set_title(title_of(true));
  if (is_pair)
    first_->show_pair(pair_);
  else if (has_face || (frame && frame->bare))
    first_->show_frame(frame);
  else
    first_->show_message(empty_reason());
  second_->setVisible(options_.second ? !is_pair : options_.comparison == Comparison::kSideBySide);
  if (options_.second)
    show_second();
  else if (has_face)
    second_->show_frame(frame);
  else
    second_->show_message(empty_reason());
}

void InspectPage::show_state() {
  const auto& recording = inspection_.recording();
  const bool is_recording = !options_.recording.empty();
  time_line_->setVisible(is_recording);
  if (recording) time_line_->set_recording(recording->count, recording->frames_per_s);
  if (const auto& frame = inspection_.frame(); frame && is_recording)
    time_line_->set_shown(frame->number, QString::fromStdString(frame->result.frame->name));
  side_->set_frame_count(is_recording && recording ? recording->count : 0);
  save_bar_->set_can_save(can_save());
  shown_->setText(shown_text());
  std::vector<Problem> problems;
  const bool is_loading = session_.status().finger.state == FingerState::kLoading;
  if (inspection_.problem() && !is_loading) problems.push_back(Problem::of(*inspection_.problem()));
  add_pair_problems(problems);
  problems_->set_problems(std::move(problems));
  pair_box_->show_pair(is_recording);
  if (!inspection_.frame()) first_->show_message(empty_reason());
  if (!inspection_.frame() && !options_.second) second_->show_message(empty_reason());
}

QString InspectPage::shown_text() const {
  return options_.recording.empty() ? tr("Shown: the live finger")
                                    : tr("Shown: %1").arg(text_of(options_.recording.filename()));
}

QString InspectPage::empty_reason() const {
  const auto& frame = inspection_.frame();
  if (frame && !frame->is_calibrated)
    return tr("The finger is not calibrated yet, so brightness cannot be told as depth.");
  if (frame && !frame->result.problems.empty())
    return window_sentence(frame->result.problems.front());
  if (frame) return tr("The face was not found in this picture.");
  if (session_.status().finger.state == FingerState::kLoading)
    return tr("The finger is being loaded.");
  if (inspection_.problem()) return tr("Nothing can be shown; above stands why.");
  if (!options_.recording.empty()) return tr("The recording is being opened.");
  const LiveStatus& status = session_.status();
  if (status.source.state == SourceState::kClosed)
    return tr("No source is open. Choose one above, or open a recording.");
  if (!status.finger.finger) return tr("No finger is open. Open the one that is seen, above.");
  return tr("Waiting for the first picture.");
}

void InspectPage::show_probe() {
  const auto& frame = inspection_.frame();
  const bool is_measured = pointed_at_ && frame && (frame->surface || frame->bare);
  const auto text = is_measured
                        ? probe_text(*frame, nearest_pixel({pointed_at_->x(), pointed_at_->y()}))
                        : std::nullopt;
  static_cast<ElidedLabel*>(probe_)->set_text(
      text ? joined_clauses({text->depth, text->position})
           : tr("Point at the face: what lies there is told here."));
  for (InspectPane* pane : {first_, second_})
    pane->show_at_pointer(
        text && pane->underMouse() ? text->depth + QLatin1Char('\n') + text->position : QString());
}

}  // namespace alltact
