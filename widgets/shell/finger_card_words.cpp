#include "widgets/shell/finger_card_words.h"

#include "core/utc_time.h"
#include "widgets/language.h"
#include "widgets/shell/finger_cards.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>

namespace alltact {
namespace {

QDateTime local_time(const std::string& utc) {
  return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
}

/// The action that brings the missing evidence of a calibration.
QString evidence_due_text(const FingerCard& card) {
  const auto lacks = [&card](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), card.lacks) != names.end();
  };
  if (!card.grade || lacks({"basis_stored", "complete"}))
    return FingerCards::tr("Due: calibrate it again");
  if (lacks({"fresh"})) return FingerCards::tr("Due: a check");
  if (lacks({"held_out", "presses", "positions", "thirds", "depths", "scale_known"}))
    return FingerCards::tr("Due: more presses");
  return FingerCards::tr("Due: read its verdict");
}

QString in_mm(double value) {
  return FingerCards::tr("%1 mm").arg(local_mm(value, 3));
}

}  // namespace

Headline headline_of(const FingerCard& card) {
  if (card.grade) {
    Headline headline = headline_of(*card.grade, card.error_mm, card.must_repeat, card.reference);
    if (card.due == FingerDue::kCalibrateAgain) headline.meaning = Meaning::kBad;
    if (card.due != FingerDue::kNothing && headline.meaning == Meaning::kGood)
      headline.meaning = Meaning::kDoubtful;
    return headline;
  }
  if (card.due == FingerDue::kRepair)
    return headline_of(Grade::kUnfit, 0, card.must_repeat, card.reference);
  const bool is_new = card.due == FingerDue::kRecording || card.due == FingerDue::kCalibration;
  return {is_new ? FingerCards::tr("Not calibrated yet")
                 : FingerCards::tr("Calibrated; how well is not kept"),
          Meaning::kDoubtful};
}

QString local_day(const std::string& utc) {
  const QDateTime time = local_time(utc);
  return time.isValid() ? QLocale().toString(time.date(), QLocale::ShortFormat) : QString();
}

QString age_in_days(const std::string& utc, const std::string& now) {
  const QDateTime then = local_time(utc), today = local_time(now);
  if (!then.isValid() || !today.isValid()) return {};
  const auto days = static_cast<int>(then.date().daysTo(today.date()));
  if (days <= 0) return FingerCards::tr("today");
  if (days == 1) return FingerCards::tr("yesterday");
  return FingerCards::tr("%n days ago", nullptr, days);
}

QString dates_of(const FingerCard& card) {
  const QString made = local_day(card.calibrated_on), checked = local_day(card.checked_on);
  if (made.isEmpty()) return {};
  return checked.isEmpty() ? FingerCards::tr("Calibrated %1").arg(made)
                           : FingerCards::tr("Calibrated %1, checked %2").arg(made, checked);
}

QString due_text(const FingerCard& card) {
  switch (card.due) {
    case FingerDue::kRecording:
      return FingerCards::tr("Due: record it bending");
    case FingerDue::kCalibration:
      return FingerCards::tr("Due: calibrate it");
    case FingerDue::kRepair:
      return card.reference == ReferenceState::kMissing
                 ? FingerCards::tr("Due: restore its reference")
                 : FingerCards::tr("Due: record its reference again");
    case FingerDue::kEvidence:
      return evidence_due_text(card);
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
    case FingerDue::kMorePresses:
      return FingerCards::tr("Due: a check");
    case FingerDue::kInspect:
      return FingerCards::tr("Drifting: look at the last check");
    case FingerDue::kCalibrateAgain:
    case FingerDue::kRepeat:
      return FingerCards::tr("Due: calibrate it again");
    case FingerDue::kNothing:
      break;
  }
  return FingerCards::tr("Nothing is due");
}

QString findings_text(const FingerCard& card) {
  QStringList lines;
  for (const Message& finding : card.findings) lines << window_sentence(finding);
  return lines.join(QLatin1Char('\n'));
}

QString summary_of(const FingerCard& card, const std::string& now) {
  QStringList parts{headline_of(card).text};
  const QString made = age_in_days(card.calibrated_on, now);
  if (!made.isEmpty()) parts << FingerCards::tr("calibrated %1").arg(made);
  const QString checked = age_in_days(card.checked_on, now);
  if (!checked.isEmpty())
    parts << FingerCards::tr("checked %1, %2 off").arg(checked, in_mm(card.checked_mm));
  parts << due_text(card);
  return parts.join(QString::fromUtf8(" \u00b7 "));
}

}  // namespace alltact
