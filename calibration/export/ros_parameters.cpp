#include "calibration/export/export_texts.h"
#include "core/yaml/yaml_writer.h"

#include <fmt/format.h>

namespace alltact {
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
  return lines;
}

Texts contact_lines(const ContactSettings& contact) {
  std::vector<double> u, v;
  for (const Eigen::Vector2d& marker : contact.rest_markers) {
    u.push_back(marker.x());
    v.push_back(marker.y());
  }
  return {number("threshold_px", contact.threshold_px),
          numbers("rest_markers_u_px", u),
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
