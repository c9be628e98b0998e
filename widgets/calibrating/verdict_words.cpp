#include "widgets/calibrating/verdict_words.h"

#include "calibration/checks/finger_worth.h"
#include "core/utc_time.h"
#include "widgets/calibrating/press_model.h"
#include "widgets/calibrating/verdict_page.h"
#include "widgets/language.h"

namespace alltact {

QString grade_text(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return VerdictPage::tr("Good");
    case Grade::kUsable:
      return VerdictPage::tr("Usable for contact and its place");
    case Grade::kUnproven:
      return VerdictPage::tr("Unproven");
    case Grade::kUnfit:
      break;
  }
  return VerdictPage::tr("Not fit to measure with");
}

Meaning meaning_of(Grade grade) {
  if (grade == Grade::kGood) return Meaning::kGood;
  return grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful;
}

QString symbol_name(Meaning meaning) {
  return meaning == Meaning::kGood       ? QStringLiteral("good")
         : meaning == Meaning::kDoubtful ? QStringLiteral("doubtful")
                                         : QStringLiteral("bad");
}

Meaning meaning_of_error(double error_mm) {
  if (error_mm <= kGoodErrorMm) return Meaning::kGood;
  return error_mm <= kUsableErrorMm ? Meaning::kDoubtful : Meaning::kBad;
}

QString error_word(Meaning meaning) {
  return meaning == Meaning::kGood       ? VerdictPage::tr("good", "an error")
         : meaning == Meaning::kDoubtful ? VerdictPage::tr("fair", "an error")
                                         : VerdictPage::tr("poor", "an error");
}

std::optional<Verdict> verdict_of(const CalibrationRun& run) {
  if (run.result()) return run.result()->verdict;
  if (!run.finger() || !run.finger()->finger.mapping_record) return std::nullopt;
  return verdict(evidence_in(*run.finger(), utc_now()));
}

QString forecast_text(const PressForecast& forecast, const CalibrationRun& run) {
  if (forecast.problem())
    return VerdictPage::tr("With the presses as they are now there is no calibration: %1")
        .arg(window_sentence(forecast.problem()->what));
  const auto& then = forecast.result();
  if (!then)
    return forecast.is_working()
               ? VerdictPage::tr("What the presses come to now is being worked out.")
               : QString();
  const QString now =
      VerdictPage::tr("With the presses as they are now: %1 mm, %2")
          .arg(local_mm(then->verdict.error_mm, 3), grade_text(then->verdict.grade));
  const auto used = verdict_of(run);
  return used ? VerdictPage::tr("%1 (in use: %2 mm).").arg(now, local_mm(used->error_mm, 3))
              : as_sentence(now);
}

}  // namespace alltact
