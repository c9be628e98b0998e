// What an effect of a scene takes, as its own reader says it.
#pragma once

#include "core/simulation/effect.h"

#include <string>
#include <vector>

namespace alltact {

struct EffectParameter {
  std::string key;     ///< with its unit: "radius_mm"
  std::string values;  ///< "a number above 0 and up to 100", "one of normal, z"; in English
  bool in_example;     ///< false: may be left out, or goes with another form of the effect
};

struct EffectDescription {
  const EffectKind* kind;
  Message sentence;  ///< what it does
  bool may_be_several;
  std::vector<EffectParameter> parameters;
};

/// Made by its example, and by giving each key what it cannot take: nothing is written twice. Keys
/// that only another form of the effect reads (vignetting's coefficients) are not found.
[[nodiscard]] EffectDescription describe(const EffectKind& kind);

/// All kinds in the order they run.
[[nodiscard]] std::vector<EffectDescription> describe_effects();

}  // namespace alltact
