#include "core/simulation/tip_deflection.h"

namespace alltact {

TipDeflection::TipDeflection(YamlSection& section) {
  if (section.has("give_mm"))
    deflection_mm_ = Varying::read(section, "give_mm", strength_up_to(100));
}

Status TipDeflection::validate(const SceneFacts& scene) const {
  if (deflection_mm_ && scene.finger.face.kind == FaceKind::kFlat)
    return Error{en::say("a flat sensor does not give way"), "", en::say("leave give_mm out")};
  return {};
}

void TipDeflection::shape(const FrameContext& frame, const Varying& s_mm, FaceCurve& curve) const {
  if (!deflection_mm_) return;
  // Modes t^2 and t^3 - t^2. K is the integral of the products of their second derivatives, (4 2; 2
  // 4), so q is along (4 p1 - 2 p2, 4 p2 - 2 p1) with p the modes at the press. Only the first mode
  // moves the tip.
  const double t = frame(s_mm) / curve.length_mm();
  const double p1 = t * t, p2 = t * t * (t - 1.0);
  const double q1 = -frame(*deflection_mm_);
  curve.bend(q1, q1 * (4.0 * p2 - 2.0 * p1) / (4.0 * p1 - 2.0 * p2));
}

}  // namespace alltact
