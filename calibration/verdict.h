// What a calibration is worth, in millimetres and in words.
#pragma once

#include <string>

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
  double error_mm = 0;   ///< the one that counts: on presses left out, or on its own with one press
  std::string sentence;  ///< grade, figure and what to do about it
};

/// Good up to this error, usable up to the other.
inline constexpr double kGoodErrorMm = 0.06;
inline constexpr double kUsableErrorMm = 0.15;

/// held_out_mm is 0 when there was only one press to learn from.
[[nodiscard]] Verdict verdict(double residual_mm, double held_out_mm, int press_count);

}  // namespace alltact
