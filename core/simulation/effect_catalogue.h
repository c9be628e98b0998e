// The parameters of an effect, as its own reader describes them.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/simulation/effect.h"

#include <string>
#include <string_view>
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

// The run time of every effect on this computer.

/// YAML of an example scene: a finger of 960 x 540 pixels that bends a little between frames, with
/// layer, LEDs, quantisation, the given kinds and their needs. The kind `without` is left out.
[[nodiscard]] std::string example_scene(const std::vector<std::string_view>& kinds,
                                        std::string_view without = {});

struct EffectCost {
  const EffectKind* kind;
  /// Time that the example adds to a frame on one thread, per million pixels. Timer noise may make
  /// it negative.
  double ms_per_megapixel;
};

/// Measures every kind in running order: the median of `repetitions` frames with the effect minus
/// the same frames without it. Error: stopped before the end.
[[nodiscard]] Result<std::vector<EffectCost>> measure_effect_costs(int repetitions, const Job& job);

/// "radiance".
[[nodiscard]] std::string_view to_string(Stage stage);

}  // namespace alltact
