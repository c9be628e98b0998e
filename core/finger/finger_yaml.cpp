// finger.yaml, to and from a Finger.
#include "core/finger/camera_yaml.h"
#include "core/finger/finger.h"
#include "core/finger/yaml_reader.h"
#include "core/finger/yaml_writer.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"

#include <cmath>

#include <yaml-cpp/exceptions.h>

namespace alltact {
namespace {

using Words = std::vector<std::string_view>;

// In the order of the enums, which count from 1.
const Words kFaceKinds{"fin_ray", "flat"};
const Words kPolarities{"bright", "dark", "auto"};
const Words kMappingKinds{"polynomial", "moebius"};
const Words kAlongs{"z", "normal", "projected"};

template <class E>
E read_word(YamlSection& section, const std::string& key, const Words& words) {
  return static_cast<E>(section.word(key, words) + 1);
}
template <class E>
std::string word_of(const Words& words, E value) {
  return std::string(words.at(static_cast<std::size_t>(value) - 1));
}

Face read_face(YamlSection section) {
  Face face;
  face.kind = read_word<FaceKind>(section, "kind", kFaceKinds);
  if (face.kind == FaceKind::kFinRay) face.width_mm = section.number("width_mm", "a length in mm");
  face.layer_mm = section.number("layer_mm", "a length in mm");
  if (face.kind == FaceKind::kFlat && section.has("plane_z_mm"))
    face.plane_z_mm = section.number("plane_z_mm", "a distance in mm");
  section.keep_the_rest();
  return face;
}

MarkerRows read_markers(YamlSection section) {
  MarkerRows markers;
  markers.per_row = section.whole_number("per_row", "the dots on one side face");
  if (section.has("polarity"))
    markers.polarity = read_word<Polarity>(section, "polarity", kPolarities);
  if (section.has("missing"))
    for (const double number : section.numbers("missing")) {
      if (number != std::floor(number) || std::abs(number) > 1000)
        section.refuse("missing", "must be a list of whole numbers", "[3, 9]");
      markers.missing.push_back(static_cast<int>(number));
    }
  section.keep_the_rest();
  return markers;
}

Eigen::MatrixXd read_covariance(YamlSection& section) {
  const auto rows = section.rows("covariance");
  const std::size_t size = rows.size();
  Eigen::MatrixXd covariance(size, size);
  for (std::size_t row = 0; row < size; ++row) {
    if (rows[row].size() != size)
      section.refuse("covariance", "must have as many numbers in each row as there are rows", "");
    for (std::size_t column = 0; column < size; ++column)
      covariance(static_cast<int>(row), static_cast<int>(column)) = rows[row][column];
  }
  return covariance;
}

/// `powers` is for people; where it contradicts what counts, someone has edited the wrong line.
void check_powers(YamlSection& section, const MappingParameters& parameters) {
  const std::vector<double> stated = section.numbers("powers");
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return;  // validate() will say why
  const std::vector<double> powers = mapping->powers();
  bool is_same = stated.size() == powers.size();
  double stated_scale = 0, x = 1;  // of the terms at the end of the domain
  for (double power : powers) stated_scale += std::abs(power) * x, x *= parameters.x_max;
  x = 1;
  for (std::size_t i = 0; is_same && i < powers.size(); ++i, x *= parameters.x_max)
    is_same = std::abs(stated[i] - powers[i]) * x <= 1e-6 * stated_scale;
  if (!is_same)
    section.refuse("powers",
                   "is not the curve that 'chebyshev' gives",
                   "remove this line: it is only for people to read");
}

FaceVariation read_variation(YamlSection section) {
  FaceVariation variation;
  variation.part = {section.number("along", "a part of the depth"),
                    section.number("across", "a part of the depth")};
  const auto read_pair = [&](const char* key) {
    const std::vector<double> numbers = section.numbers(key);
    if (numbers.size() != 2)
      section.refuse(key, "must be two numbers: mm along and across the face", "");
    return Eigen::Vector2d(numbers[0], numbers[1]);
  };
  variation.middle_mm = read_pair("middle_mm");
  variation.half_mm = read_pair("half_mm");
  section.keep_the_rest();
  return variation;
}

MappingParameters read_mapping(YamlSection& section) {
  MappingParameters parameters;
  parameters.kind = read_word<MappingKind>(section, "kind", kMappingKinds);
  if (section.has("along")) parameters.along = read_word<MappingAlong>(section, "along", kAlongs);
  const std::vector<double> domain = section.numbers("domain");
  if (domain.size() != 2 || domain[0] != 0)
    section.refuse("domain", "must be two numbers, the first of them 0", "for example [0.0, 0.62]");
  parameters.x_max = domain[1];
  if (section.has("varies")) parameters.variation = read_variation(section.section("varies"));
  if (section.has("covariance")) parameters.covariance = read_covariance(section);
  if (parameters.kind == MappingKind::kMoebius) {
    parameters.a_mm = section.number("a_mm", "a depth in mm");
    parameters.b = section.number("b", "without unit");
  } else {
    parameters.chebyshev = section.numbers("chebyshev");
    if (section.has("powers")) check_powers(section, parameters);
  }
  return parameters;
}

std::optional<MappingRecord> read_record(YamlSection& section) {
  const std::array keys{
      "method", "presses", "residual_mm", "held_out_mm", "spread_mm", "pixel_mm", "degree_choice"};
  if (std::none_of(keys.begin(), keys.end(), [&](const char* key) { return section.has(key); }))
    return std::nullopt;
  MappingRecord record;
  if (section.has("method")) record.method = section.text("method");
  if (section.has("presses")) record.presses = section.texts("presses");
  if (section.has("residual_mm")) record.residual_mm = section.number("residual_mm", "in mm");
  if (section.has("held_out_mm")) record.held_out_mm = section.number("held_out_mm", "in mm");
  if (section.has("spread_mm")) record.spread_mm = section.number("spread_mm", "in mm");
  if (section.has("pixel_mm")) record.pixel_mm = section.number("pixel_mm", "in mm");
  if (section.has("degree_choice")) record.degree_choice = section.text("degree_choice");
  return record;
}

ReferenceFiles read_reference(YamlSection section, FaceKind kind) {
  ReferenceFiles files;
  if (section.has("image") || (kind == FaceKind::kFlat && !section.has("video"))) {
    files.image = section.text("image");
  } else {
    files.video = section.text("video");
    files.markers = section.text("markers");
    if (section.has("places")) {
      const std::vector<double> places = section.numbers("places");
      if (places.size() != 2)
        section.refuse("places", "must be two numbers: a column in px, a step in mm", "");
      files.places = PosePlaces{places[0], places[1]};
    }
  }
  section.keep_the_rest();
  return files;
}

ContactSettings read_contact(YamlSection section) {
  ContactSettings contact;
  contact.threshold_px = section.number("threshold_px", "a sum of offsets in pixels");
  for (const std::vector<double>& row : section.rows("rest_markers")) {
    if (row.size() != 2)
      section.refuse("rest_markers", "must hold two numbers for each marker", "[[u, v], ...]");
    contact.rest_markers.emplace_back(row[0], row[1]);
  }
  section.keep_the_rest();
  return contact;
}

RigidTransform read_gripper(YamlSection section) {
  RigidTransform pose;
  const std::vector<double> at = section.numbers("translation_mm");
  if (at.size() != 3) section.refuse("translation_mm", "must be three numbers: x, y, z in mm", "");
  pose.translation_mm = {at[0], at[1], at[2]};
  const std::vector<double> turn = section.numbers("rotation");
  if (turn.size() != 4)
    section.refuse("rotation", "must be four numbers: w, x, y, z of a unit quaternion", "");
  pose.rotation = {turn[0], turn[1], turn[2], turn[3]};
  section.keep_the_rest();
  return pose;
}

Finger read_finger(YamlSection& top) {
  Finger finger;
  if (const std::string format = top.text("format"); format != Finger::kFormat)
    top.refuse("format",
               fmt::format("'{}' cannot be read by this version", printable(format)),
               fmt::format("a newer version of this program, or '{}'", Finger::kFormat));
  finger.name = top.text("name");
  YamlSection camera = top.section("camera");
  finger.camera = read_camera(camera, finger.lens_record);
  finger.face = read_face(top.section("face"));
  if (finger.face.kind == FaceKind::kFinRay || top.has("markers"))
    finger.markers = read_markers(top.section("markers"));
  if (top.has("mapping")) {
    YamlSection mapping = top.section("mapping");
    finger.mapping = read_mapping(mapping);
    finger.mapping_record = read_record(mapping);
    mapping.keep_the_rest();
  }
  if (top.has("reference"))
    finger.reference = read_reference(top.section("reference"), finger.face.kind);
  if (top.has("contact")) finger.contact = read_contact(top.section("contact"));
  if (top.has("force")) {
    YamlSection force = top.section("force");
    finger.force_model = force.text("model");
    if (finger.force_model.empty()) force.refuse("model", "must name a file", "force.yaml");
    force.keep_the_rest();
  }
  if (top.has("gripper_from_camera"))
    finger.gripper_from_camera = read_gripper(top.section("gripper_from_camera"));
  if (top.has("provenance")) {
    YamlSection provenance = top.section("provenance");
    finger.provenance = provenance.all_texts();
    provenance.keep_the_rest();
  }
  top.keep_the_rest();
  return finger;
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

void add_record(const MappingRecord& record, YamlBlock& block) {
  std::vector<std::string> presses;
  for (const std::string& press : record.presses) presses.push_back(yaml_text(press));
  block.add("method", yaml_text(record.method));
  block.add("presses", yaml_list(presses));
  block.add("residual_mm", yaml_number(record.residual_mm));
  block.add("held_out_mm", yaml_number(record.held_out_mm));
  if (record.spread_mm > 0) block.add("spread_mm", yaml_number(record.spread_mm));
  if (record.pixel_mm > 0) block.add("pixel_mm", yaml_number(record.pixel_mm));
  block.add("degree_choice", yaml_text(record.degree_choice));
}

std::string mapping_text(const MappingParameters& parameters,
                         const std::optional<MappingRecord>& record,
                         const UnknownKeys& unknown) {
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
  if (record) add_record(*record, block);
  block.add_unknown(unknown);
  return block.on_many_lines();
}

std::string reference_text(const ReferenceFiles& files, const UnknownKeys& unknown) {
  YamlBlock block("reference");
  if (files.image.empty()) {
    block.add("video", yaml_text(files.video));
    block.add("markers", yaml_text(files.markers));
    if (files.places)
      block.add("places", yaml_numbers({files.places->from_u_px, files.places->step_mm}));
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
  const Eigen::Vector3d& at = pose.translation_mm;
  const Eigen::Quaterniond& turn = pose.rotation;
  block.add("translation_mm", yaml_numbers({at.x(), at.y(), at.z()}));
  block.add("rotation", yaml_numbers({turn.w(), turn.x(), turn.y(), turn.z()}));
  block.add_unknown(unknown);
  return block.on_one_line();
}

/// A valid finger as a file.
std::string text_of(const Finger& finger, const UnknownKeys& unknown) {
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

}  // namespace

struct Finger::Unknown {
  UnknownKeys keys;
};

Result<Finger> Finger::load(const std::filesystem::path& folder,
                            std::vector<std::string>* warnings) {
  const std::filesystem::path path = folder / kFileName;
  const auto content = read_file(path, kMaxYamlBytes);
  if (!content) return content.error();
  return parse(*content, path, warnings);
}

Result<Finger> Finger::parse(const std::string& yaml,
                             const std::filesystem::path& origin,
                             std::vector<std::string>* warnings) {
  YamlFile file{origin, {}, {}, {}};
  try {
    YamlSection top = YamlSection::top(file, yaml);
    Finger finger = read_finger(top);
    if (const Status status = finger.validate(); !status) return located(file, status.error());
    finger.unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown)});
    if (warnings != nullptr) *warnings = std::move(file.warnings);
    return finger;
  } catch (const Refused& refused) {
    return refused.error;
  } catch (const YAML::Exception& problem) {
    return Error{"this is not YAML: " + problem.msg, origin.string(), "look at its brackets"};
  }
}

Result<std::string> Finger::to_yaml() const {
  static const UnknownKeys kNone;
  if (const Status status = validate(); !status) return status.error();
  return text_of(*this, unknown_ ? unknown_->keys : kNone);
}

Status Finger::save(const std::filesystem::path& folder) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(folder / kFileName, *text);
}

}  // namespace alltact
