// The run time of every effect on this computer.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "core/simulation/effect.h"

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

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
