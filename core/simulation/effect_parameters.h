// The parameters of an effect, as its own reader describes them.
#pragma once

#include "core/simulation/effect.h"

#include <string>
#include <vector>

namespace alltact {

struct EffectParameter {
  std::string key;     ///< with its unit: "radius_mm"
  std::string values;  ///< "a number above 0 and up to 100", "one of normal, z"; in English
  bool in_example;     ///< false: optional, or used by another form of the effect
};

struct EffectDescription {
  const EffectKind* kind;
  Message sentence;  ///< what the effect does
  bool is_repeatable;
  std::vector<EffectParameter> parameters;
};

/// Derived from the kind's example and from its errors for invalid values, so that nothing is
/// written twice. Keys that only another form of the effect reads (vignetting's coefficients) are
/// not found.
[[nodiscard]] EffectDescription describe(const EffectKind& kind);

/// All kinds in running order.
[[nodiscard]] std::vector<EffectDescription> describe_effects();

}  // namespace alltact
