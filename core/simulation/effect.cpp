#include "core/simulation/effect.h"

namespace alltact {

BuildCount& build_count() {
  static BuildCount count;
  return count;
}

Status check_position(const SceneFacts& scene, const Varying& s_mm, const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (face.kind == FaceKind::kFlat) return {};
  if (s_mm.min_value() < 0 || s_mm.max_value() > scene.length_mm)
    return Error{
        en::say("s_mm is beyond the ends of the face"), "", en::say("0 to {:g}", scene.length_mm)};
  if (y_mm.min_value() < -face.width_mm / 2 || y_mm.max_value() > face.width_mm / 2)
    return Error{en::say("y_mm is beside the face"),
                 "",
                 en::say("{:g} to {:g}", -face.width_mm / 2, face.width_mm / 2)};
  return {};
}

Status check_press(const SceneFacts& scene,
                   const Varying& depth_mm,
                   const Varying& s_mm,
                   const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (depth_mm.max_value() >= face.layer_mm)
    return Error{en::say("depth_mm = {:g} goes through the layer of {:g} mm",
                         depth_mm.max_value(),
                         face.layer_mm),
                 "",
                 en::say("less than finger.face.layer_mm")};
  return check_position(scene, s_mm, y_mm);
}

}  // namespace alltact
