// The grades of calibrations, checks and presses as text in the window's language.
// calibration/verdict decides the grade; every page, card, dialog and sheet takes its text from
// here.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/verdict/verdict.h"
#include "core/sensing/pipeline_settings.h"
#include "widgets/theme.h"

#include <QString>
#include <optional>
#include <vector>

namespace alltact {

[[nodiscard]] QString grade_text(Grade grade);
[[nodiscard]] Meaning meaning_of(Grade grade);
[[nodiscard]] QString check_text(CheckVerdict verdict);
[[nodiscard]] Meaning meaning_of(CheckVerdict verdict);

/// A verdict whose advice names the window's button instead of a command.
[[nodiscard]] Verdict window_verdict(CalibrationEvidence evidence);

/// The expected error, mm; only for good and usable calibrations.
[[nodiscard]] std::optional<double> expected_error_mm(const Verdict& verdict);

/// "Changed since it was calibrated"
[[nodiscard]] QString changed_text();

/// The line above everything else.
struct Headline {
  QString text;  ///< "Good, ±0.035 mm", "Changed since it was calibrated", "Broken"
  Meaning meaning = Meaning::kDoubtful;
};
///   error_mm: see expected_error_mm; 0: none
///   must_repeat: numbers or reference differ from those of the calibration
[[nodiscard]] Headline headline_of(Grade grade, double error_mm, bool must_repeat,
                                   ReferenceState reference);

/// All contradictions of the calibration, then its missing requirements, worst first, each with
/// advice.
[[nodiscard]] std::vector<Message> findings_of(const Verdict& verdict,
                                               const std::vector<Contradiction>& contradictions);

/// A press's error, mm: the error of a mapping that was fitted without it. The only number that the
/// window calls a press's error. nullopt: no mapping was fitted without it.
[[nodiscard]] std::optional<double> press_error_mm(const BallFit& ball);
/// By the limits kGoodErrorMm and kUsableErrorMm.
[[nodiscard]] Meaning meaning_of_error(double error_mm);
/// "good", "fair", "poor".
[[nodiscard]] QString error_word(Meaning meaning);

/// In the number format of the window's language.
[[nodiscard]] QString local_mm(double value, int digits);

// Settings as text in the window's language.

/// "nearest recorded image, no smoothing": the settings of `choice` that differ from `base`; empty
/// where none does.
[[nodiscard]] QString difference_words(const PipelineSettings& choice,
                                       const PipelineSettings& base);

}  // namespace alltact
