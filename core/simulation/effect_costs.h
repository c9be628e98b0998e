// What every effect costs on this computer.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "core/simulation/effect.h"

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A finger of 960 x 540 pixels that bends a little from frame to frame, with layer, LEDs and
/// quantisation, and with the named kinds and what their examples need, as a scene's text; without
/// the kind `without`.
[[nodiscard]] std::string example_scene(const std::vector<std::string_view>& kinds,
                                        std::string_view without = {});

struct EffectCost {
  const EffectKind* kind;
  /// What its example adds to the time of a frame on one thread, per million pixels of the picture;
  /// noise of the clock may take it below 0.
  double ms_per_megapixel;
};

/// Every kind there is, in the order they run; the median of `repetitions` frames with the effect
/// beside the same frames without it. Error: stopped before the end.
[[nodiscard]] Result<std::vector<EffectCost>> measure_effect_costs(int repetitions, const Job& job);

/// "radiance".
[[nodiscard]] std::string_view to_string(Stage stage);

}  // namespace alltact
