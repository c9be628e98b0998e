#include "calibration/export/description_json.h"
#include "calibration/export/export_texts.h"
#include "calibration/verdict/verdict_json.h"
#include "core/sensing/depth/smoothing.h"

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

Json covariance_json(const Eigen::MatrixXd& covariance) {
  Json rows = Json::array();
  for (Eigen::Index r = 0; r < covariance.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < covariance.cols(); ++c) row.push_back(covariance(r, c));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Along either axis, for image and reference alike.
std::vector<double> full_kernel(const Smoothing& smoothing) {
  std::vector<double> kernel(smoothing.weights.rbegin(), smoothing.weights.rend());
  kernel.insert(kernel.end(), smoothing.weights.begin() + 1, smoothing.weights.end());
  return kernel;
}

Json mapping_json(const Mapping& mapping, const std::optional<MappingRecord>& record) {
  const MappingParameters& parameters = mapping.parameters();
  Json json;
  json["formula"] = "depth_mm = M(x), x = (reference - picture) / reference";
  json["along"] = to_string(parameters.along);
  json["domain"] = {0.0, parameters.x_max};
  if (parameters.kind == MappingKind::kPolynomial) {
    json["kind"] = "polynomial";
    json["chebyshev_mm"] = parameters.chebyshev;
    json["powers_mm"] = mapping.powers();
  } else {
    json["kind"] = "moebius";
    json["a_mm"] = parameters.a_mm;
    json["b"] = parameters.b;
  }
  if (const FaceVariation& varies = parameters.variation; !varies.is_none()) {
    json["varies"] = {
        {"formula",
         "depth_mm = M(x) (1 + along s + across t), (s, t) = (place - middle) / half, "
         "each from -1 to 1, place in mm along the face from its base and across it"},
        {"along", varies.part.x()},
        {"across", varies.part.y()},
        {"middle_mm", {varies.middle_mm.x(), varies.middle_mm.y()}},
        {"half_mm", {varies.half_mm.x(), varies.half_mm.y()}}};
  }
  if (parameters.covariance.size() > 0) json["covariance"] = covariance_json(parameters.covariance);
  if (record) {
    json["method"] = record->method;
    json["presses"] = record->presses;
    json["residual_mm"] = record->residual_mm;
    if (record->held_out_mm > 0) json["held_out_mm"] = record->held_out_mm;
    if (record->spread_mm > 0) json["spread_mm"] = record->spread_mm;
    if (record->pixel_mm > 0) json["pixel_mm"] = record->pixel_mm;
    json["degree_choice"] = record->degree_choice;
  }
  return json;
}

Json reference_json(const ReferenceFiles& files) {
  Json json;
  if (!files.image.empty()) {
    json["image"] = files.image;
  } else {
    json["video"] = files.video;
    json["markers"] = files.markers;
  }
  return json;
}

}  // namespace

Result<std::string> calibration_json(const Finger& finger,
                                     const PipelineSettings& settings,
                                     const std::optional<Verdict>& worth) {
  Json json;
  json["format"] = "alltact-calibration/1";
  json["name"] = finger.name;
  json["camera"] = camera_json(finger.camera);
  const bool flat = finger.face.kind == FaceKind::kFlat;
  json["face"] = face_json(finger.face);
  if (!flat) json["markers"]["per_row"] = finger.markers.per_row;
  if (!finger.markers.missing.empty()) json["markers"]["missing"] = finger.markers.missing;
  if (finger.mapping) {
    const auto mapping = Mapping::create(*finger.mapping);
    if (!mapping) return mapping.error();
    json["mapping"] = mapping_json(*mapping, finger.mapping_record);
    if (worth) json["verdict"] = verdict_json(*worth);
    json["mapping"]["smoothing"] = full_kernel(smoothing_of(settings.smoothing_px));
  }
  if (finger.contact) {
    Json& contact = json["contact"];
    contact["threshold_px"] = finger.contact->threshold_px;
    for (const auto& marker : finger.contact->rest_markers)
      contact["rest_markers_px"].push_back({marker.x(), marker.y()});
  }
  if (finger.gripper_from_camera) {
    const Eigen::Vector3d& at = finger.gripper_from_camera->translation_mm;
    const Eigen::Quaterniond& turn = finger.gripper_from_camera->rotation;
    json["gripper_from_camera"] = {{"translation_mm", {at.x(), at.y(), at.z()}},
                                   {"rotation_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}}};
  }
  if (finger.reference) json["reference"] = reference_json(*finger.reference);
  json["provenance"] = finger.provenance;
  // Names and remarks may contain invalid UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace alltact
