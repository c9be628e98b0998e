#include "widgets/shell/finger_card_words.h"

#include "core/utc_time.h"
#include "widgets/shell/finger_cards.h"

#include <QDateTime>
#include <QLocale>
#include <cmath>

namespace alltact {
namespace {

QDateTime local_time(const std::string& utc) {
  return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
}

QString in_mm(double value) {
  return FingerCards::tr("%1 mm").arg(QLocale().toString(value, 'f', 3));
}

}  // namespace

QString grade_word(const FingerCard& card) {
  if (!card.grade && (card.due == FingerDue::kRecording || card.due == FingerDue::kCalibration))
    return FingerCards::tr("Not calibrated yet");
  if (!card.grade) return FingerCards::tr("Calibrated; how well is not kept");
  switch (*card.grade) {
    case Grade::kGood:
      return FingerCards::tr("Good");
    case Grade::kUsable:
      return FingerCards::tr("Usable for contact and its place");
    case Grade::kUnproven:
      return FingerCards::tr("Unproven");
    case Grade::kUnfit:
      break;
  }
  return FingerCards::tr("Not fit to measure with");
}

Meaning meaning_of(const FingerCard& card) {
  if (!card.grade) return Meaning::kDoubtful;
  if (*card.grade == Grade::kUnfit || card.due == FingerDue::kAgain) return Meaning::kBad;
  const bool is_well = card.due == FingerDue::kNothing && *card.grade == Grade::kGood;
  return is_well ? Meaning::kGood : Meaning::kDoubtful;
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

QString due_text(FingerDue due) {
  switch (due) {
    case FingerDue::kRecording:
      return FingerCards::tr("Due: record it bending");
    case FingerDue::kCalibration:
      return FingerCards::tr("Due: calibrate it");
    case FingerDue::kRepair:
      return FingerCards::tr("Due: repair its reference");
    case FingerDue::kEvidence:
      return FingerCards::tr("Due: more presses");
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
    case FingerDue::kMorePresses:
      return FingerCards::tr("Due: a check");
    case FingerDue::kLook:
      return FingerCards::tr("Drifting: look at the last check");
    case FingerDue::kAgain:
    case FingerDue::kRepeat:
      return FingerCards::tr("Due: calibrate it again");
    case FingerDue::kNothing:
      break;
  }
  return FingerCards::tr("Nothing is due");
}

QString summary_of(const FingerCard& card, const std::string& now) {
  QStringList parts{grade_word(card)};
  if (card.error_mm > 0) parts.back() += QString::fromUtf8(", \u00b1") + in_mm(card.error_mm);
  const QString made = age_in_days(card.calibrated_on, now);
  if (!made.isEmpty()) parts << FingerCards::tr("calibrated %1").arg(made);
  const QString checked = age_in_days(card.checked_on, now);
  if (!checked.isEmpty())
    parts << FingerCards::tr("checked %1, %2 off").arg(checked, in_mm(card.checked_mm));
  parts << due_text(card.due);
  return parts.join(QString::fromUtf8(" \u00b7 "));
}

}  // namespace alltact
