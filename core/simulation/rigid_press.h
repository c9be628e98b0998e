// Common base of all rigid bodies that press into the face.
#pragma once

#include "core/simulation/bodies/body.h"
#include "core/simulation/effect.h"
#include "core/simulation/tip_deflection.h"

#include <memory>

namespace alltact {

/// A rigid body. Parameters: `s_mm`, `y_mm`: the position below its origin. `depth_mm`: its point
/// nearest to the finger lies so far along z below the tangent plane of the undeformed outer side
/// there. Rotations in order: `roll_deg` about the finger's length, `tilt_deg` about its width (the
/// end towards the tip moves away from the finger), `rotation_deg` about the face's normal, from
/// the finger's length towards +y. `give_mm`: see Give.
class RigidPress : public GeometryEffect {
 public:
  explicit RigidPress(YamlSection& section);

  bool is_repeatable() const override { return true; }
  std::optional<PressKind> presses() const override { return PressKind::kBody; }
  Status validate(const SceneFacts& scene) const override;
  void shape(const FrameContext& frame, FaceCurve& curve) const override;
  void apply(const FrameContext& frame, FrameGeometry& geometry) const override;

 protected:
  /// Call once, from the derived constructor.
  void set_body(std::shared_ptr<const Body> body) { body_ = std::move(body); }

 private:
  Varying depth_, s_, y_, rotation_deg_, tilt_deg_, roll_deg_;
  TipDeflection tip_deflection_;
  std::shared_ptr<const Body> body_;
};

}  // namespace alltact
