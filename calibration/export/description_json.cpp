#include "calibration/export/description_json.h"

namespace alltact {

nlohmann::ordered_json camera_json(const CameraParameters& camera) {
  nlohmann::ordered_json json;
  json["model"] = to_string(camera.model);
  json["size_px"] = {camera.width_px, camera.height_px};
  if (camera.model == CameraModel::kOrthographic) {
    json["mm_per_px"] = camera.mm_per_px;
  } else {
    json["fx_px"] = camera.fx_px;
    json["fy_px"] = camera.fy_px;
  }
  json["cx_px"] = camera.cx_px;
  json["cy_px"] = camera.cy_px;
  json["distortion"] = camera.distortion;
  json["orientation"] = to_string(camera.orientation);
  if (camera.port)
    json["port"] = {{"gap_mm", camera.port->gap_mm},
                    {"plate_mm", camera.port->plate_mm},
                    {"plate_index", camera.port->plate_index},
                    {"medium_index", camera.port->medium_index}};
  return json;
}

nlohmann::ordered_json face_json(const Face& face) {
  const bool flat = face.kind == FaceKind::kFlat;
  nlohmann::ordered_json json;
  json["kind"] = flat ? "flat" : "fin_ray";
  if (flat)
    json["plane_z_mm"] = face.plane_z_mm;
  else
    json["width_mm"] = face.width_mm;
  json["layer_mm"] = face.layer_mm;
  return json;
}

}  // namespace alltact
