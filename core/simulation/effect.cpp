#include "core/simulation/effect.h"

namespace alltact {

BuildCount& build_count() {
  static BuildCount count;
  return count;
}

Status place_fits(const SceneFacts& scene, const Varying& s_mm, const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (face.kind == FaceKind::kFlat) return {};
  if (s_mm.least() < 0 || s_mm.greatest() > scene.length_mm)
    return Error{
        en::say("s_mm is beyond the ends of the face"), "", en::say("0 to {:g}", scene.length_mm)};
  if (y_mm.least() < -face.width_mm / 2 || y_mm.greatest() > face.width_mm / 2)
    return Error{en::say("y_mm is beside the face"),
                 "",
                 en::say("{:g} to {:g}", -face.width_mm / 2, face.width_mm / 2)};
  return {};
}

Status press_fits(const SceneFacts& scene,
                  const Varying& depth_mm,
                  const Varying& s_mm,
                  const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (depth_mm.greatest() >= face.layer_mm)
    return Error{en::say("depth_mm = {:g} goes through the layer of {:g} mm",
                         depth_mm.greatest(),
                         face.layer_mm),
                 "",
                 en::say("less than finger.face.layer_mm")};
  return place_fits(scene, s_mm, y_mm);
}

}  // namespace alltact
