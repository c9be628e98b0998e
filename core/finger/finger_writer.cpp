// Writer of finger.yaml.
#include "core/base/yaml.h"
#include "core/finger/finger_yaml.h"

namespace alltact {
namespace {

template <class E>
std::string word_of(const FingerWords& words, E value) {
  return std::string(words.at(static_cast<std::size_t>(value) - 1));
}

std::string face_text(const Face& face, const UnknownKeys& unknown) {
  YamlBlock block("face");
  block.add("kind", word_of(kFaceKinds, face.kind));
  if (face.kind == FaceKind::kFinRay) block.add("width_mm", yaml_number(face.width_mm));
  block.add("layer_mm", yaml_number(face.layer_mm));
  if (face.kind == FaceKind::kFlat) block.add("plane_z_mm", yaml_number(face.plane_z_mm));
  block.add_unknown(unknown);
  return block.on_many_lines();
}

std::string markers_text(const MarkerRows& markers, const UnknownKeys& unknown) {
  YamlBlock block("markers");
  block.add("per_row", fmt::format("{}", markers.per_row));
  block.add("polarity", word_of(kPolarities, markers.polarity));
  if (!markers.missing.empty()) {
    std::vector<std::string> numbers;
    for (const int number : markers.missing) numbers.push_back(fmt::format("{}", number));
    block.add("missing", yaml_list(numbers));
  }
  block.add_unknown(unknown);
  return block.on_one_line();
}

std::string basis_text(const CalibrationBasis& basis, const UnknownKeys& unknown) {
  YamlBlock block("mapping.basis");
  block.add("ball_radii_mm", yaml_numbers(basis.ball_radii_mm));
  block.add("face_mm", yaml_numbers({basis.width_mm, basis.layer_mm, basis.plane_z_mm}));
  block.add("camera", '"' + basis.camera + '"');
  block.add("reference", '"' + basis.reference + '"');
  block.add("positions", fmt::format("{}", basis.positions));
  block.add("thirds", fmt::format("[{}]", fmt::join(basis.thirds, ", ")));
  block.add("position_leverage", yaml_number(basis.position_leverage));
  block.add("depths_mm", yaml_numbers({basis.shallowest_mm, basis.deepest_mm}));
  block.add("scale_sd_mm", yaml_number(basis.scale_sd_mm));
  block.add("pixel_sd_mm", yaml_number(basis.pixel_sd_mm));
  block.add("halo_mm", yaml_number(basis.halo_mm));
  block.add("depth_per_radius", yaml_number(basis.depth_per_radius));
  block.add("left_out", fmt::format("{}", basis.left_out));
  block.add("complete", basis.is_complete ? "true" : "false");
  if (!basis.contradictions.empty()) {
    std::vector<std::string> kinds, rows;
    for (const RecordedContradiction& one : basis.contradictions) {
      kinds.push_back(yaml_text(one.kind));
      rows.push_back(yaml_numbers({static_cast<double>(one.presses), static_cast<double>(one.of),
                                   one.given_mm, one.measured_mm, one.measured_to_mm}));
    }
    block.add("contradictions", yaml_list(kinds));
    block.add("contradictions_mm", yaml_list(rows));
  }
  block.add_unknown(unknown);
  return block.in_braces();
}

void add_record(const MappingRecord& record, const UnknownKeys& unknown, YamlBlock& block) {
  std::vector<std::string> presses;
  for (const std::string& press : record.presses) presses.push_back(yaml_text(press));
  block.add("method", yaml_text(record.method));
  block.add("presses", yaml_list(presses));
  block.add("residual_mm", yaml_number(record.residual_mm));
  block.add("held_out_mm", yaml_number(record.held_out_mm));
  if (record.spread_mm > 0) block.add("spread_mm", yaml_number(record.spread_mm));
  if (record.pixel_mm > 0) block.add("pixel_mm", yaml_number(record.pixel_mm));
  block.add("degree_choice", yaml_text(record.degree_choice));
  if (record.basis) block.add("basis", basis_text(*record.basis, unknown));
}

std::string mapping_text(const MappingParameters& parameters,
                         const std::optional<MappingRecord>& record, const UnknownKeys& unknown) {
  YamlBlock block("mapping");
  block.add("kind", word_of(kMappingKinds, parameters.kind));
  block.add("along", std::string(to_string(parameters.along)));
  block.add("domain", yaml_numbers({0, parameters.x_max}));
  if (parameters.kind == MappingKind::kMoebius) {
    block.add("a_mm", yaml_number(parameters.a_mm));
    block.add("b", yaml_number(parameters.b));
  } else {
    block.add("chebyshev", yaml_numbers(parameters.chebyshev));
    block.add("powers", yaml_numbers(Mapping::create(parameters)->powers()));
  }
  if (const FaceVariation& varies = parameters.variation; !varies.is_none()) {
    YamlBlock inner("mapping.varies");
    inner.add("along", yaml_number(varies.part.x()));
    inner.add("across", yaml_number(varies.part.y()));
    inner.add("middle_mm", yaml_numbers({varies.middle_mm.x(), varies.middle_mm.y()}));
    inner.add("half_mm", yaml_numbers({varies.half_mm.x(), varies.half_mm.y()}));
    inner.add_unknown(unknown);
    block.add("varies", inner.in_braces());
  }
  if (const Eigen::MatrixXd& covariance = parameters.covariance; covariance.size() != 0) {
    std::vector<std::string> rows;
    for (const auto& row : covariance.rowwise())
      rows.push_back(yaml_numbers(std::vector<double>(row.begin(), row.end())));
    block.add("covariance", yaml_list(rows));
  }
  if (record) add_record(*record, unknown, block);
  block.add_unknown(unknown);
  return block.on_many_lines();
}

std::string reference_text(const ReferenceFiles& files, const UnknownKeys& unknown) {
  YamlBlock block("reference");
  if (files.image.empty()) {
    block.add("video", yaml_text(files.video));
    block.add("markers", yaml_text(files.markers));
    if (files.positions)
      block.add("places", yaml_numbers({files.positions->from_u_px, files.positions->step_mm}));
  } else {
    block.add("image", yaml_text(files.image));
  }
  block.add_unknown(unknown);
  return block.on_one_line();
}

std::string contact_text(const ContactSettings& contact, const UnknownKeys& unknown) {
  std::vector<std::string> markers;
  for (const Eigen::Vector2d& marker : contact.rest_markers)
    markers.push_back(yaml_numbers({marker.x(), marker.y()}));
  YamlBlock block("contact");
  block.add("threshold_px", yaml_number(contact.threshold_px));
  block.add("rest_markers", yaml_list(markers));
  block.add_unknown(unknown);
  return block.on_many_lines();
}

std::string gripper_text(const RigidTransform& pose, const UnknownKeys& unknown) {
  YamlBlock block("gripper_from_camera");
  add_pose(pose, block);
  block.add_unknown(unknown);
  return block.on_one_line();
}

}  // namespace

std::string finger_text(const Finger& finger, const UnknownKeys& unknown) {
  YamlBlock head("");
  head.add("format", Finger::kFormat);
  head.add("name", yaml_text(finger.name));
  std::string text = head.on_many_lines();

  YamlBlock camera("camera");
  add_camera(finger.camera, finger.lens_record, unknown, camera);
  camera.add_unknown(unknown);
  text += camera.on_many_lines();
  text += face_text(finger.face, unknown);
  if (finger.face.kind == FaceKind::kFinRay) text += markers_text(finger.markers, unknown);
  if (finger.mapping) text += mapping_text(*finger.mapping, finger.mapping_record, unknown);
  if (finger.reference) text += reference_text(*finger.reference, unknown);
  if (finger.contact) text += contact_text(*finger.contact, unknown);
  if (!finger.force_model.empty()) {
    YamlBlock force("force");
    force.add("model", yaml_text(finger.force_model));
    force.add_unknown(unknown);
    text += force.on_one_line();
  }
  if (finger.gripper_from_camera) text += gripper_text(*finger.gripper_from_camera, unknown);
  YamlBlock provenance("provenance");
  for (const auto& [key, value] : finger.provenance)
    provenance.add(key, yaml_text_or_number(value));
  provenance.add_unknown(unknown);
  if (!provenance.is_empty()) text += provenance.on_many_lines();

  YamlBlock rest("");
  rest.add_unknown(unknown);
  return text + rest.on_many_lines();
}

}  // namespace alltact
