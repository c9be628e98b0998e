#include "core/simulation/effect.h"

namespace alltact {

Status press_fits(const SceneFacts& scene,
                  const Varying& depth_mm,
                  const Varying& s_mm,
                  const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (depth_mm.greatest() >= face.layer_mm)
    return Error{fmt::format("depth_mm = {:g} goes through the layer of {:g} mm",
                             depth_mm.greatest(),
                             face.layer_mm),
                 "",
                 "less than finger.face.layer_mm"};
  if (face.kind == FaceKind::kFlat) return {};
  if (s_mm.least() < 0 || s_mm.greatest() > scene.length_mm)
    return Error{
        "s_mm is beyond the ends of the face", "", fmt::format("0 to {:g}", scene.length_mm)};
  if (y_mm.least() < -face.width_mm / 2 || y_mm.greatest() > face.width_mm / 2)
    return Error{"y_mm is beside the face",
                 "",
                 fmt::format("{:g} to {:g}", -face.width_mm / 2, face.width_mm / 2)};
  return {};
}

}  // namespace alltact
