// Gage R&R: how much of the variation of measurements comes from the measuring itself.
//
// Parts (fingers, or whatever is measured), operators and repeats are crossed: each operator
// measures each part equally often. Analysis of variance as in AIAG, Measurement Systems Analysis,
// 4th edition (2010), appendix A, with random parts and operators:
//   value = mean + part + operator + interaction + repetition.
// An interaction that chance explains with more than 5 % is pooled with the repetitions. Negative
// estimates of a variance are 0. Intervals of the gage's standard deviation: modified large-sample
// method, Burdick, Borror, Montgomery, Journal of Quality Technology 35 (2003) 342; those of the
// repeatability are exact for normal repetitions.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct GageReading {
  std::string part, operator_name;
  double value = 0;  ///< finite; mm in all files of this program
};

/// `f` and `p` are empty where there is nothing to divide by.
struct AnovaRow {
  double ss = 0;  ///< sum of squares
  int df = 0;     ///< degrees of freedom
  double ms = 0;  ///< ss / df; 0 without freedom
  std::optional<double> f, p;
};

struct SdInterval {
  double low = 0, high = 0;
};

/// Standard deviations have the unit of the readings.
struct GageStudy {
  std::vector<std::string> parts, operators;  ///< in the order of their first reading
  int repeats = 0;
  double mean = 0;
  /// `interaction` has no freedom with one part or operator. f and p of parts and operators refer
  /// to the interaction or, where it is pooled, to the repetitions with it.
  AnovaRow by_part, by_operator, interaction, repetition, total;
  bool is_pooled = false;      ///< the repetitions include the interaction
  double repeatability = 0;    ///< equipment variation, EV
  double operators_sd = 0;     ///< of operators alone
  double interaction_sd = 0;   ///< 0 where it is pooled
  double reproducibility = 0;  ///< appraiser variation, AV: operators and interaction
  double gage = 0;             ///< repeatability and reproducibility, GRR
  double parts_sd = 0;         ///< part variation, PV
  double total_sd = 0;         ///< TV
  SdInterval repeatability_95, gage_95;
  int categories = 0;  ///< distinct ones, 1.41 PV / GRR; 0 also where the gage has no variation

  /// Of the total variation, in percent; 0 where nothing varies.
  [[nodiscard]] double percent(double sd) const;
  /// Six standard deviations of a tolerance's width > 0, in percent.
  [[nodiscard]] static double percent_of(double tolerance, double sd);
};

/// Errors: a reading that is not finite; readings whose squares are not representable; fewer than
/// two parts or operators in all; a combination of them without a reading; fewer than two repeats;
/// combinations with different numbers of readings.
[[nodiscard]] Result<GageStudy> gage_study(const std::vector<GageReading>& readings);

/// The last readings of each combination, as many as all have, in the given order. `left_out`: how
/// many there are besides.
[[nodiscard]] std::vector<GageReading> balanced(const std::vector<GageReading>& readings,
                                                std::size_t& left_out);

/// What the study found, for people. `tolerance_mm`: width; 0: none.
[[nodiscard]] Message gage_sentence(const GageStudy& study, double tolerance_mm);

}  // namespace alltact
