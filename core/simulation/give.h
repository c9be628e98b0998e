// How a finger gives way to what presses on its contact face.
#pragma once

#include "core/simulation/effect.h"

#include <optional>

namespace alltact {

/// Read from `give_mm` of what presses: how far the tip goes back, against the contact face's
/// normal. Without the key the finger stands firm. The finger bends in the two modes of the effect
/// `bend`, in the mix that a force at the press's place gives a clamped beam (Ritz: K q = P
/// phi(a)).
class Give {
 public:
  explicit Give(YamlSection& section);

  [[nodiscard]] Status fits(const SceneFacts& scene) const;
  void shape(const FrameContext& frame, const Varying& s_mm, FaceCurve& curve) const;

 private:
  std::optional<Varying> give_mm_;
};

}  // namespace alltact
