#include "widgets/verdict_text.h"

#include "widgets/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>

namespace alltact {
namespace {

struct VerdictText {
  Q_DECLARE_TR_FUNCTIONS(alltact::VerdictText)
};

/// Requirements that report a contradiction of the calibration; all others report missing evidence.
constexpr std::array<std::string_view, 5> kContradicting{"reference_whole", "numbers_unchanged",
                                                         "ball_possible", "reference_older",
                                                         "numbers_consistent"};

bool is_broken(ReferenceState reference) {
  return reference != ReferenceState::kIntact && reference != ReferenceState::kAbsent;
}

}  // namespace

QString grade_text(Grade grade) { return window_phrase(word_of(grade)); }

Meaning meaning_of(Grade grade) {
  if (grade == Grade::kGood) return Meaning::kGood;
  return grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful;
}

QString check_text(CheckVerdict verdict) { return window_phrase(word_of(verdict)); }

Meaning meaning_of(CheckVerdict verdict) {
  if (verdict == CheckVerdict::kPass) return Meaning::kGood;
  return verdict == CheckVerdict::kRecalibrate ? Meaning::kBad : Meaning::kDoubtful;
}

Verdict window_verdict(CalibrationEvidence evidence) {
  evidence.repeat_command = en::say("calibrate again from the stored presses");
  return verdict(evidence);
}

std::optional<double> expected_error_mm(const Verdict& verdict) {
  const bool is_vouched = verdict.grade == Grade::kGood || verdict.grade == Grade::kUsable;
  return is_vouched && verdict.error_mm > 0 ? std::optional(verdict.error_mm) : std::nullopt;
}

QString changed_text() { return VerdictText::tr("Changed since it was calibrated"); }

Headline headline_of(Grade grade, double error_mm, bool must_repeat, ReferenceState reference) {
  if (is_broken(reference)) return {VerdictText::tr("Broken"), Meaning::kBad};
  if (must_repeat)
    return {changed_text(), grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful};
  return {error_mm > 0 ? VerdictText::tr("%1, ±%2 mm", "a grade and the expected error")
                             .arg(grade_text(grade), local_mm(error_mm, 3))
                       : grade_text(grade),
          meaning_of(grade)};
}

std::vector<Message> findings_of(const Verdict& verdict,
                                 const std::vector<Contradiction>& contradictions) {
  std::vector<Message> contradicting, lacking;
  // A verdict has all contradictions of a kind in one sentence; here each has its own.
  const auto add_each = [&](bool ruling_out) {
    for (const Contradiction& one : contradictions)
      if (rules_out_use(one.kind) == ruling_out) contradicting.push_back(sentence(one));
  };
  for (std::size_t i = 0; i < verdict.missing.size(); ++i) {
    const std::string_view name = verdict.missing_names[i];
    const bool is_of_numbers = name == "ball_possible" || name == "numbers_consistent";
    if (is_of_numbers && !contradictions.empty())
      add_each(name == "ball_possible");
    else if (std::find(kContradicting.begin(), kContradicting.end(), name) != kContradicting.end())
      contradicting.push_back(verdict.missing[i]);
    else
      lacking.push_back(verdict.missing[i]);
  }
  contradicting.insert(contradicting.end(), lacking.begin(), lacking.end());
  return contradicting;
}

std::optional<double> press_error_mm(const BallFit& ball) {
  return ball.held_out_mm > 0 ? std::optional(ball.held_out_mm) : std::nullopt;
}

Meaning meaning_of_error(double error_mm) {
  if (error_mm <= kGoodErrorMm) return Meaning::kGood;
  return error_mm <= kUsableErrorMm ? Meaning::kDoubtful : Meaning::kBad;
}

QString error_word(Meaning meaning) {
  return meaning == Meaning::kGood       ? VerdictText::tr("good", "an error")
         : meaning == Meaning::kDoubtful ? VerdictText::tr("fair", "an error")
                                         : VerdictText::tr("poor", "an error");
}

QString local_mm(double value, int digits) { return QLocale().toString(value, 'f', digits); }

QString difference_words(const PipelineSettings& choice, const PipelineSettings& base) {
  QStringList differences;
  for (const auto& setting : pipeline_settings())
    if (setting.get(choice) != setting.get(base))
      differences << in_window_language(setting.phrase(choice));
  return joined(differences);
}

}  // namespace alltact
