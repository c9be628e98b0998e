#include "calibration/hard_cases/hard_cases.h"

#include "calibration/hard_cases/groups.h"

namespace alltact {

FaceShape flat_sensor(const cv::Size& size, double mm_per_px) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = size.width, p.height_px = size.height;
  p.cx_px = 0.5 * (size.width - 1), p.cy_px = 0.5 * (size.height - 1);
  p.mm_per_px = mm_per_px;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  face.plane_z_mm = 20.0;
  return FaceShape::plane(Camera::create(p).value(), face);
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (const auto group : {hard_directions,
                           hard_outlines,
                           hard_faces,
                           hard_curves,
                           hard_lenses,
                           hard_brightness,
                           hard_contacts})
    for (HardCase& one : group()) all.push_back(std::move(one));
  return all;
}

}  // namespace alltact
