// The deflection of a finger under what presses on its contact face.
#pragma once

#include "core/simulation/effect.h"

#include <optional>

namespace alltact {

/// Read from `give_mm` of a pressing effect: the tip's deflection against the contact face's
/// normal. Without the key the finger is rigid. The finger bends in the two modes of the effect
/// `bend`, in the ratio that a force at the press gives a clamped beam (Ritz: K q = P phi(a)).
class TipDeflection {
 public:
  explicit TipDeflection(YamlSection& section);

  [[nodiscard]] Status validate(const SceneFacts& scene) const;
  void shape(const FrameContext& frame, const Varying& s_mm, FaceCurve& curve) const;

 private:
  std::optional<Varying> deflection_mm_;
};

}  // namespace alltact
