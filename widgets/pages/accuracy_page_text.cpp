// Texts and figures of the page Accuracy.
#include "calibration/finger/calibration_inputs.h"
#include "calibration/study/study_front.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/settings_words.h"

#include <QDateTime>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kMinReportedChange = 0.02;  // of time or error; smaller changes are not reported

QString millimetres(double mm) {
  return QLocale().toString(mm, 'f', mm < 0.1 ? 4 : 3);
}

QString milliseconds(double ms) {
  return QLocale().toString(ms, 'f', 2);
}

QString with_capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

QString AccuracyPage::row_words(const StudyRow& row) const {
  const QString words = difference_words(row.settings, shown_->study.rows.front().settings);
  return words.isEmpty() ? tr("as calibrated") : words;
}

QString AccuracyPage::figures_of(const StudyRow& row) const {
  QStringList clauses{
      tr("%1 ms a picture; depth: half of all points within %2 mm, 95 % within %3 mm")
          .arg(milliseconds(frame_ms(shown_->study, row)),
               millimetres(row.depth->median_mm),
               millimetres(error_p95_mm(shown_->study, row).value_or(row.depth->p95_mm)))};
  if (row.position_mm) clauses << tr("place: half within %1 mm").arg(millimetres(*row.position_mm));
  return joined_clauses(clauses);
}

QString AccuracyPage::hint_of(const StudyRow& row) const {
  QStringList lines{figures_of(row)};
  if (!is_proven(row.settings, shown_->study.rows.front().settings))
    lines << tr("What it loses is not in these pictures, whose light is that of the recording.");
  const QString other = difference_words(row.settings, run_.settings_in_use());
  if (other.isEmpty()) {
    lines << tr("In use now.");
    return lines.join(QLatin1Char('\n'));
  }
  lines << tr("Other than now: %1").arg(other);
  const auto in_use = run_.row_in_use();
  if (!in_use || !shown_->study.rows[*in_use].depth) return lines.join(QLatin1Char('\n'));
  const StudyRow& now = shown_->study.rows[*in_use];
  const double more_ms = frame_ms(shown_->study, row) - frame_ms(shown_->study, now);
  const double more_mm = row.depth->median_mm - now.depth->median_mm;
  if (std::abs(more_ms) > kMinReportedChange * frame_ms(shown_->study, now))
    lines << (more_ms < 0 ? tr("%1 ms faster than now") : tr("%1 ms slower than now"))
                 .arg(milliseconds(std::abs(more_ms)));
  if (std::abs(more_mm) > kMinReportedChange * now.depth->median_mm)
    lines << (more_mm < 0 ? tr("%1 mm closer than now") : tr("%1 mm further off than now"))
                 .arg(millimetres(std::abs(more_mm)));
  return lines.join(QLatin1Char('\n'));
}

std::optional<std::size_t> AccuracyPage::point_of_row(std::size_t row) const {
  const auto found = std::find(rows_.begin(), rows_.end(), row);
  return found == rows_.end() ? std::nullopt
                              : std::optional(static_cast<std::size_t>(found - rows_.begin()));
}

AccuracyPoint AccuracyPage::point_of(std::size_t number) const {
  const AccuracyStudy& study = shown_->study;
  const StudyRow& row = study.rows[number];
  AccuracyPoint point;
  point.words = row_words(row);
  point.hint = hint_of(row);
  point.time_ms = frame_ms(study, row);
  point.median_mm = row.depth->median_mm;
  point.p95_mm = error_p95_mm(study, row).value_or(row.depth->p95_mm);
  point.position_mm = row.position_mm;
  point.is_on_front = std::find(front_.begin(), front_.end(), number) != front_.end();
  point.is_in_use = run_.row_in_use() == number;
  point.is_proven = is_proven(row.settings, study.rows.front().settings);
  if (const auto better = dominated_by(study, front_, number))
    point.dominated_by = point_of_row(*better);
  return point;
}

QString AccuracyPage::study_obstacle() const {
  const FingerPtr& finger = run_.finger();
  if (folder_.empty()) return tr("Open a finger first.");
  if (!finger) return tr("The finger is being read.");
  if (!finger->mapping) return tr("Calibrate this finger first.");
  if (!finger->finger.reference) return tr("Record this finger's reference first.");
  return {};
}

void AccuracyPage::show_run() {
  show_progress();
  const QString reason = study_obstacle();
  first_reason_->setText(reason);
  first_reason_->setVisible(!reason.isEmpty());
  measure_->setEnabled(reason.isEmpty() && !run_.is_running());
  measure_->setAccessibleDescription(reason);
  const std::string in_use = key_of(run_.settings_in_use());
  if (run_.study() == shown_ && in_use == shown_in_use_) return;
  if (run_.study() != shown_) picked_.reset();
  shown_ = run_.study();
  shown_in_use_ = in_use;
  pages_->setCurrentIndex(shown_ ? 1 : 0);
  show_points();
  show_answer();
}

void AccuracyPage::show_progress() {
  const bool is_running = run_.is_running();
  progress_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * run_.work().fraction()));
  const auto left = run_.work().seconds_left();
  left_->setText(left ? tr("about %n second(s) left", nullptr, static_cast<int>(std::ceil(*left)))
                      : tr("measuring what settings cost…"));
  more_->setEnabled(!is_running && study_obstacle().isEmpty());
}

void AccuracyPage::show_points() {
  rows_.clear();
  front_.clear();
  std::vector<AccuracyPoint> points;
  if (shown_) {
    front_ = pareto_front(shown_->study);
    for (std::size_t i = 0; i < shown_->study.rows.size(); ++i)
      if (shown_->study.rows[i].depth) rows_.push_back(i);
    for (const std::size_t row : rows_) points.push_back(point_of(row));
  }
  table_->set_points(points);
  plot_->set_points(std::move(points));
}

QString AccuracyPage::standing_text() const {
  if (!shown_->is_of_finger_now)
    return tr("The finger has changed since this was measured: measure again.");
  if (!shown_->is_of_this_computer)
    return tr("Measured on another computer (%1): its errors hold, its times do not.")
        .arg(QString::fromStdString(shown_->computer));
  if (!shown_->has_all_single) return tr("Measuring was stopped: some settings are missing.");
  return {};
}

QString AccuracyPage::answer_note() const {
  const AccuracyStudy& study = shown_->study;
  const auto rate_of = [&](std::size_t row) {
    return QLocale().toString(std::floor(1000 / frame_ms(study, study.rows[row])), 'f', 0);
  };
  if (picked_) return tr("Chosen by hand. Esc in the figure returns to the answer.");
  const QString budget = QLocale().toString(question_.budget_ms(), 'f', 1);
  const QString error = millimetres(question_.error_mm.value_or(0));
  switch (study_answer_->kind) {
    case StudyAnswerKind::kMostAccurate:
      return tr("The most accurate of all that take at most %1 ms.").arg(budget);
    case StudyAnswerKind::kErrorMet:
      return tr("The fastest that keeps 95 % of all points within %1 mm.").arg(error);
    case StudyAnswerKind::kErrorTooSmall:
      return tr("No setting keeps %1 mm. This is the most accurate that takes at most %2 ms.")
          .arg(error, budget);
    case StudyAnswerKind::kErrorTooSlow:
      return tr("Keeping %1 mm allows %2 pictures per second. This is the most accurate that is "
                "fast enough.")
          .arg(error, rate_of(*study_answer_->within_error));
    case StudyAnswerKind::kTooSlow:
      break;
  }
  return tr("No setting is so fast on this computer. This is the fastest: %1 pictures per second.")
      .arg(rate_of(study_answer_->row));
}

void AccuracyPage::show_answer() {
  study_answer_ = shown_ ? answer_to(question_, shown_->study) : std::nullopt;
  const auto row = answer_row();
  const auto in_use = run_.row_in_use();
  if (row) {
    answer_->setText(with_capital(row_words(shown_->study.rows[*row])));
    figures_->setText(as_sentence(with_capital(figures_of(shown_->study.rows[*row]))));
    note_->setText(answer_note());
  } else {
    answer_->setText(shown_ ? tr("No setting measures this finger's pictures.") : QString());
    figures_->clear();
    note_->clear();
  }
  const QString standing = shown_ ? standing_text() : QString();
  standing_->setText(standing);
  standing_->setVisible(!standing.isEmpty());
  const bool is_used = row && in_use == row;
  use_->setText(is_used ? tr("In use") : tr("&Use it"));
  use_->setEnabled(row && !is_used);
  as_calibrated_->setVisible(shown_ && in_use != std::size_t{0});
  if (shown_) {
    const bool is_good = shown_->is_of_finger_now && shown_->is_of_this_computer;
    more_->setText(!is_good                  ? tr("&Measure again (about 12 s)")
                   : !shown_->has_all_single ? tr("&Measure what is missing")
                                             : tr("&Measure pairs of settings, too"));
    more_->setVisible(!is_good || !shown_->has_all_pairs);
  }
  command_->setText(command_line());
  command_->setCursorPosition(0);
  const auto point = row ? point_of_row(*row) : std::nullopt;
  plot_->pick(point);
  table_->pick(point);
  show_sides();
}

// Compares with the setting in use or, where that is the answer, with that of the calibration.
void AccuracyPage::show_sides() {
  if (!shown_) return;
  const auto& rows = shown_->study.rows;
  const auto words = [&](const PipelineSettings& settings) {
    const QString other = difference_words(settings, rows.front().settings);
    return other.isEmpty() ? tr("as calibrated") : other;
  };
  const PipelineSettings& now = run_.settings_in_use();
  const auto row = answer_row();
  const PipelineSettings& chosen =
      row && run_.row_in_use() != row ? rows[*row].settings : rows.front().settings;
  sides_->compare(run_.finger(), {now, words(now)}, {chosen, words(chosen)});
}

QString AccuracyPage::command_line() const {
  if (folder_.empty()) return {};
  std::string command = fmt::format(
      "alltact study {} --within-ms {:.4g}", shell_quoted(folder_.string()), question_.budget_ms());
  if (question_.error_mm) command += fmt::format(" --keep-mm {:g}", *question_.error_mm);
  return QString::fromStdString(command);
}

}  // namespace alltact
