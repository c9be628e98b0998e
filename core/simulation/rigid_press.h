// Common base of all rigid bodies that press into the face.
#pragma once

#include "core/simulation/effect.h"
#include "core/simulation/press.h"

#include <memory>
#include <optional>

namespace alltact {

// The deflection of a finger under what presses on its contact face.

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

/// A rigid body. Parameters: `s_mm`, `y_mm`: the position below its origin. `depth_mm`: its point
/// nearest to the finger lies so far along z below the tangent plane of the undeformed outer side
/// there. Rotations in order: `roll_deg` about the finger's length, `tilt_deg` about its width (the
/// end towards the tip moves away from the finger), `rotation_deg` about the face's normal, from
/// the finger's length towards +y. `give_mm`: see Give.
class RigidPress : public GeometryEffect {
 public:
  /// read_body: reads the body's own parameters.
  RigidPress(YamlSection& section, std::shared_ptr<const Body> (*read_body)(YamlSection&));

  bool is_repeatable() const override { return true; }
  bool presses_body() const override { return true; }
  Status validate(const SceneFacts& scene) const override;
  void shape(const FrameContext& frame, FaceCurve& curve) const override;
  void apply(const FrameContext& frame, FrameGeometry& geometry) const override;

 private:
  Varying depth_, s_, y_, rotation_deg_, tilt_deg_, roll_deg_;
  TipDeflection tip_deflection_;
  std::shared_ptr<const Body> body_;
};

/// The effect of one kind of body, for effect_kind().
template <std::shared_ptr<const Body> (*read_body)(YamlSection&)>
class RigidPressOf final : public RigidPress {
 public:
  explicit RigidPressOf(YamlSection& section) : RigidPress(section, read_body) {}
};

}  // namespace alltact
