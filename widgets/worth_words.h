// What a calibration, a check and a press are worth, in the window's words. Which word it is,
// calibration/verdict decides; every page, card, dialog and sheet takes its words from here.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/verdict/verdict.h"
#include "widgets/theme.h"

#include <QString>
#include <optional>
#include <vector>

namespace alltact {

[[nodiscard]] QString grade_text(Grade grade);
[[nodiscard]] Meaning meaning_of(Grade grade);
[[nodiscard]] QString check_text(CheckVerdict verdict);
[[nodiscard]] Meaning meaning_of(CheckVerdict verdict);

/// A verdict whose sentences send to the window's button instead of to a command.
[[nodiscard]] Verdict window_verdict(CalibrationEvidence evidence);

/// The expected error, mm, where the grade vouches for one: of good and usable calibrations only.
[[nodiscard]] std::optional<double> vouched_error_mm(const Verdict& verdict);

/// "Changed since it was calibrated"
[[nodiscard]] QString changed_text();

/// What stands above everything else.
struct Headline {
  QString text;  ///< "Good, ±0.035 mm", "Changed since it was calibrated", "Broken"
  Meaning meaning = Meaning::kDoubtful;
};
///   error_mm: see vouched_error_mm; 0: none
///   must_repeat: numbers or reference are not those of the calibration
[[nodiscard]] Headline headline_of(Grade grade,
                                   double error_mm,
                                   bool must_repeat,
                                   ReferenceState reference);

/// What contradicts the calibration, all of it, then what it lacks, worst first: each with what to
/// do.
[[nodiscard]] std::vector<Message> findings_of(const Verdict& verdict,
                                               const std::vector<Contradiction>& contradictions);

/// What a press is off by, mm: with a mapping that it had no part in. The one figure that is called
/// a press's error. nullopt: no mapping was made without it.
[[nodiscard]] std::optional<double> press_error_mm(const BallFit& ball);
/// As kGoodErrorMm and kUsableErrorMm have it.
[[nodiscard]] Meaning meaning_of_error(double error_mm);
/// "good", "fair", "poor".
[[nodiscard]] QString error_word(Meaning meaning);

/// As the window's language writes numbers.
[[nodiscard]] QString local_mm(double value, int digits);

}  // namespace alltact
