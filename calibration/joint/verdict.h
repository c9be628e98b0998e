// What a calibration is worth, in millimetres and in words.
#pragma once

#include "core/message.h"

namespace alltact {

enum class Grade {
  kGood = 1,  ///< shape and depth can be measured
  kUsable,    ///< contact and its place can, fine relief cannot
  kUnproven,  ///< fits its own presses, but nothing shows what it does on others
  kUnfit,     ///< do not measure with it
};

/// Errors in mm of press depth, mean absolute inside the contacts.
struct Verdict {
  Grade grade = Grade::kUnfit;
  /// The one that counts, to be expected of the next press: the larger of what a pixel in a contact
  /// is off by, from all causes, and what presses show: the error in shape on presses left out and
  /// how far depth is off as a whole, as the root of the sum of their squares. With one press the
  /// error on that press.
  double error_mm = 0;
  Message reason;    ///< figure and what to do about it
  Message sentence;  ///< the same behind the grade
};

/// Good up to this error, usable up to the other.
inline constexpr double kGoodErrorMm = 0.06;
inline constexpr double kUsableErrorMm = 0.15;

/// Mean absolute value of a normal error whose standard deviation is 1: sqrt(2 / pi).
inline constexpr double kMeanOfSd = 0.7978845608028654;

struct VerdictEvidence {
  double residual_mm = 0;
  double held_out_mm = 0;  ///< 0 when there was only one press to learn from
  double spread_mm = 0;    ///< see Calibration::spread_mm
  int presses = 0;
  double pixel_mm = 0;  ///< see contact_error.h; 0: unknown
};
[[nodiscard]] Verdict verdict(const VerdictEvidence& evidence);

}  // namespace alltact
