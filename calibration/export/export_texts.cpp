#include "calibration/export/export_texts.h"

#include "calibration/finger/calibration_report.h"
#include "core/base/yaml.h"
#include "core/sensing/depth/smoothing.h"

#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

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
  if (const LightSpread& spread = parameters.spread; !spread.is_local()) {
    json["spread"] = {
        {"formula",
         "before M, x is solved for y: 1 - x(p) = (1 - k(y(p + c u))) (1 - q(p + s u)), "
         "k = core y / (1 - (1 - core) y), u the displacement along the face to where the line of "
         "sight meets the layer's untouched outer side, c the part of that way on which it first "
         "meets the skin, c = 1 - d / layer with d the depth there, "
         "q - width^2 max(0.2, 1 - 2.3 e) laplace q = e, e = (1 - core) y, "
         "m = 1 / cos(sight to normal) - 1, t = optical_thickness: core = exp(-0.74 t^0.78 (1 + "
         "0.28 m)), width = width_factor 0.8 layer / t^0.4, "
         "s = 0.43 - 0.066 t; d = T (1 + b) y / (1 + b y) with T = a_mm / (1 + b of M), "
         "b = ((1 + b_straight) exp(0.8 t exp(-0.35 t) m) - 1) exp(log_b_along (along - middle) / "
         "half); then y is replaced "
         "by that of the same depth on M"},
        {"optical_thickness", spread.optical_thickness},
        {"optical_thickness_sd", spread.optical_thickness_sd},
        {"width_factor", spread.width_factor},
        {"b_straight", spread.b_straight},
        {"log_b_along", spread.log_b_along},
        {"middle_mm", spread.middle_mm},
        {"half_mm", spread.half_mm}};
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

Result<std::string> calibration_json(const Finger& finger, const PipelineSettings& settings,
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

namespace {

/// `who`: "OpenCV".
Status has_camera_matrix(const CameraParameters& camera, const std::string& who) {
  Message which;
  if (camera.model == CameraModel::kOrthographic) which = en::say("an orthographic camera");
  if (camera.port) which = en::say("a camera behind a window");
  if (which.empty()) return {};
  return Error{en::say("{} has no camera matrix, so {} cannot describe it", which, who), "",
               en::say("json, or zip for the entire finger")};
}

/// As many as OpenCV permits; missing ones are zero.
std::vector<double> all_coefficients(const CameraParameters& camera) {
  std::vector<double> all = camera.distortion;
  const std::size_t count = all.size();
  all.resize(camera.model == CameraModel::kFisheye ? 4 : count <= 5 ? 5 : count <= 8 ? 8 : 12);
  return all;
}

/// As ROS names it.
std::string distortion_model(const CameraParameters& camera, const std::string& fisheye) {
  if (camera.model == CameraModel::kFisheye) return fisheye;
  return camera.distortion.size() <= 5 ? "plumb_bob" : "rational_polynomial";
}

/// ROS allows letters, digits and '_' only.
std::string ros_name(const std::string& name) {
  std::string plain = name;
  for (char& letter : plain)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return plain;
}

std::string ros_matrix(std::string_view key, int rows, const std::vector<double>& data) {
  return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: {}\n", key, rows,
                     data.size() / static_cast<std::size_t>(rows), yaml_numbers(data));
}

}  // namespace

Result<std::string> opencv_camera(const Finger& finger) {
  const CameraParameters& camera = finger.camera;
  if (Status status = has_camera_matrix(camera, "OpenCV"); !status) return status.error();
  const cv::Mat matrix = (cv::Mat_<double>(3, 3) << camera.fx_px, 0, camera.cx_px, 0, camera.fy_px,
                          camera.cy_px, 0, 0, 1);
  // Pixels are those after orientation, the centre of the top-left one at (0, 0), as in OpenCV.
  cv::FileStorage file(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "camera_name" << finger.name;
  file << "image_width" << camera.width_px << "image_height" << camera.height_px;
  file << "camera_matrix" << matrix;
  file << "distortion_model" << distortion_model(camera, "fisheye");
  file << "distortion_coefficients" << cv::Mat(all_coefficients(camera), true).t();
  if (camera.orientation != Orientation::kNone)
    file << "orientation" << std::string(to_string(camera.orientation));
  return file.releaseAndGetString();
}

Result<std::string> ros_camera_info(const Finger& finger) {
  const CameraParameters& camera = finger.camera;
  if (Status status = has_camera_matrix(camera, "ROS"); !status) return status.error();
  const double fx = camera.fx_px, fy = camera.fy_px, cx = camera.cx_px, cy = camera.cy_px;
  std::string text;
  if (camera.orientation != Orientation::kNone)
    text = fmt::format(
        "# The numbers hold for the image after this rotation or reflection; ROS ignores the key.\n"
        "orientation: {}\n",
        to_string(camera.orientation));
  text += fmt::format("image_width: {}\nimage_height: {}\ncamera_name: {}\n", camera.width_px,
                      camera.height_px, yaml_text(ros_name(finger.name)));
  text += ros_matrix("camera_matrix", 3, {fx, 0, cx, 0, fy, cy, 0, 0, 1});
  text += fmt::format("distortion_model: {}\n", distortion_model(camera, "equidistant"));
  text += ros_matrix("distortion_coefficients", 1, all_coefficients(camera));
  text += ros_matrix("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  text += ros_matrix("projection_matrix", 3, {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0});
  return text;
}

namespace {

using Texts = std::vector<std::string>;

/// "  face:\n    width_mm: 24.0\n", indented as a node's parameters.
std::string block(const std::string& name, const Texts& lines) {
  std::string text = fmt::format("    {}:\n", name);
  for (const std::string& line : lines) text += fmt::format("      {}\n", line);
  return text;
}

std::string number(std::string_view key, double value) {
  return fmt::format("{}: {}", key, yaml_number(value));
}

std::string numbers(std::string_view key, const std::vector<double>& values) {
  return fmt::format("{}: {}", key, yaml_numbers(values));
}

Texts camera_lines(const CameraParameters& camera) {
  Texts lines = {fmt::format("model: {}", to_string(camera.model)),
                 fmt::format("orientation: {}", to_string(camera.orientation))};
  lines.push_back(fmt::format("width_px: {}", camera.width_px));
  lines.push_back(fmt::format("height_px: {}", camera.height_px));
  return lines;
}

Texts face_lines(const Face& face) {
  const bool is_flat = face.kind == FaceKind::kFlat;
  return {is_flat ? "kind: flat" : "kind: fin_ray",
          is_flat ? number("plane_z_mm", face.plane_z_mm) : number("width_mm", face.width_mm),
          number("layer_mm", face.layer_mm)};
}

Texts mapping_lines(const Mapping& mapping) {
  const MappingParameters& parameters = mapping.parameters();
  const bool is_polynomial = parameters.kind == MappingKind::kPolynomial;
  Texts lines = {is_polynomial ? "kind: polynomial" : "kind: moebius",
                 fmt::format("along: {}", yaml_text(to_string(parameters.along))),
                 numbers("domain", {0.0, parameters.x_max})};
  if (is_polynomial) {
    lines.push_back(numbers("chebyshev_mm", parameters.chebyshev));
    lines.push_back(numbers("powers_mm", mapping.powers()));
  } else {
    lines.push_back(number("a_mm", parameters.a_mm));
    lines.push_back(number("b", parameters.b));
  }
  if (const FaceVariation& varies = parameters.variation; !varies.is_none()) {
    lines.push_back(numbers("varies_along_across", {varies.part.x(), varies.part.y()}));
    lines.push_back(numbers("varies_middle_mm", {varies.middle_mm.x(), varies.middle_mm.y()}));
    lines.push_back(numbers("varies_half_mm", {varies.half_mm.x(), varies.half_mm.y()}));
  }
  if (const LightSpread& spread = parameters.spread; !spread.is_local())
    lines.insert(lines.end(), {number("spread_optical_thickness", spread.optical_thickness),
                               number("spread_optical_thickness_sd", spread.optical_thickness_sd),
                               number("spread_width_factor", spread.width_factor),
                               number("spread_b_straight", spread.b_straight),
                               number("spread_log_b_along", spread.log_b_along),
                               number("spread_middle_mm", spread.middle_mm),
                               number("spread_half_mm", spread.half_mm)});
  return lines;
}

Texts contact_lines(const ContactSettings& contact) {
  std::vector<double> u, v;
  for (const Eigen::Vector2d& marker : contact.rest_markers) {
    u.push_back(marker.x());
    v.push_back(marker.y());
  }
  return {number("threshold_px", contact.threshold_px), numbers("rest_markers_u_px", u),
          numbers("rest_markers_v_px", v)};
}

Texts gripper_lines(const RigidTransform& pose) {
  const Eigen::Vector3d& at = pose.translation_mm;
  const Eigen::Quaterniond& turn = pose.rotation;
  return {numbers("translation_mm", {at.x(), at.y(), at.z()}),
          numbers("rotation_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()})};
}

}  // namespace

Result<std::string> ros_parameters(const Finger& finger) {
  std::string text = "/**:\n  ros__parameters:\n";
  text += fmt::format("    finger_name: {}\n", yaml_text(finger.name));
  text += block("camera", camera_lines(finger.camera));
  text += block("face", face_lines(finger.face));
  if (finger.markers.per_row > 0)
    text += block("markers", {fmt::format("per_row: {}", finger.markers.per_row)});
  if (finger.mapping) {
    const auto mapping = Mapping::create(*finger.mapping);
    if (!mapping) return mapping.error();
    text += block("mapping", mapping_lines(*mapping));
  }
  if (finger.contact && !finger.contact->rest_markers.empty())
    text += block("contact", contact_lines(*finger.contact));
  if (finger.gripper_from_camera)
    text += block("gripper_from_camera", gripper_lines(*finger.gripper_from_camera));
  return text;
}

}  // namespace alltact
