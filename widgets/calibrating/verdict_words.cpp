#include "widgets/calibrating/verdict_words.h"

#include "widgets/calibrating/verdict_page.h"
#include "widgets/language.h"

namespace alltact {

std::optional<Verdict> verdict_of(const CalibrationRun& run) {
  const auto& worth = run.worth();
  return worth && worth->evidence ? std::optional(window_verdict(*worth->evidence)) : std::nullopt;
}

QString recalibration_reason(const CalibrationRun& run) {
  if (run.state() != CalibrationState::kStale) return {};
  const auto known = verdict_of(run);
  QStringList reasons;
  for (std::size_t i = 0; known && i < known->missing.size(); ++i)
    if (known->missing_names[i] == "numbers_unchanged" ||
        known->missing_names[i] == "reference_older")
      reasons << window_sentence(known->missing[i]);
  if (reasons.isEmpty())
    reasons << VerdictPage::tr("The presses have changed since this calibration.");
  return reasons.join(QLatin1Char(' '));
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
