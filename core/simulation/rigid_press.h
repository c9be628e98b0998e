// What all rigid bodies that are pressed into the face have in common.
#pragma once

#include "core/simulation/bodies/body.h"
#include "core/simulation/effect.h"
#include "core/simulation/give.h"

#include <memory>

namespace alltact {

/// A body that keeps its shape. Parameters: `s_mm`, `y_mm` the place over which its origin lies;
/// `depth_mm`: its point nearest to the finger lies so far along z below the plane that touches the
/// untouched outer side there; how it is turned, one after another: `roll_deg` about the finger's
/// length, `tilt_deg` about its width (the end towards the tip goes away from the finger) and
/// `rotation_deg` about the face's normal, from the finger's length towards +y; `give_mm`.
class RigidPress : public GeometryEffect {
 public:
  explicit RigidPress(YamlSection& section);

  bool may_be_several() const override { return true; }
  std::optional<PressKind> presses() const override { return PressKind::kBody; }
  Status fits(const SceneFacts& scene) const override;
  void shape(const FrameContext& frame, FaceCurve& curve) const override;
  void place(const FrameContext& frame, FrameGeometry& geometry) const override;

 protected:
  /// To be called once, by the constructor of what knows the body.
  void set_body(std::shared_ptr<const Body> body) { body_ = std::move(body); }

 private:
  Varying depth_, s_, y_, rotation_deg_, tilt_deg_, roll_deg_;
  Give give_;
  std::shared_ptr<const Body> body_;
};

}  // namespace alltact
