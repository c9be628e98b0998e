#include "core/finger/finger_yaml.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/camera/camera.h"
#include "core/numerics/checksum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {

namespace {

/// The enumerator of a word; the words are those of to_string().
template <class E, std::size_t N>
E read_camera_word(YamlSection& section, const std::string& key, const std::array<E, N>& meanings) {
  std::vector<std::string_view> words;
  for (E meaning : meanings) words.push_back(to_string(meaning));
  return meanings[section.choice(key, words)];
}

constexpr std::array kModels{CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye,
                             CameraModel::kOrthographic};
constexpr std::array kOrientations{Orientation::kNone,     Orientation::kFlipU,
                                   Orientation::kFlipV,    Orientation::kRotate180,
                                   Orientation::kRotate90, Orientation::kRotate270};

void read_size(YamlSection& section, CameraParameters& parameters) {
  const std::vector<double> size = section.numbers("size");
  const auto is_integer = [](double x) { return std::abs(x) < 1e9 && x == std::floor(x); };
  if (size.size() != 2 || !is_integer(size[0]) || !is_integer(size[1]))
    section.refuse("size", en::say("must be two integers"), en::say("[width, height] in pixels"));
  parameters.width_px = static_cast<int>(size[0]);
  parameters.height_px = static_cast<int>(size[1]);
}

FlatPort read_port(YamlSection& camera) {
  YamlSection section = camera.section("port");
  FlatPort port;
  port.gap_mm = section.number("gap_mm", en::say("the lens-to-window air gap in mm"));
  port.plate_mm = section.number("plate_mm", en::say("the window's thickness in mm"));
  port.plate_index = section.number("plate_index", en::say("the window's index of refraction"));
  port.medium_index = section.number("medium_index", en::say("the index of refraction behind it"));
  return port;
}

std::string in_braces(const FlatPort& port, const UnknownKeys& unknown) {
  YamlBlock block("camera.port");
  block.add("gap_mm", yaml_number(port.gap_mm));
  block.add("plate_mm", yaml_number(port.plate_mm));
  block.add("plate_index", yaml_number(port.plate_index));
  block.add("medium_index", yaml_number(port.medium_index));
  block.add_unknown(unknown);
  return block.in_braces();
}

CameraParameters read_camera(YamlSection& section, LensRecord& record) {
  CameraParameters parameters;
  parameters.model = read_camera_word(section, "model", kModels);
  read_size(section, parameters);
  if (parameters.model == CameraModel::kOrthographic) {
    parameters.mm_per_px = section.number("mm_per_px", en::say("the size of a pixel in mm"));
  } else {
    parameters.fx_px = section.number("fx", en::say("the focal length in pixels"));
    parameters.fy_px = section.number("fy", en::say("the focal length in pixels"));
  }
  parameters.cx_px = section.number("cx", en::say("the principal point in pixels"));
  parameters.cy_px = section.number("cy", en::say("the principal point in pixels"));
  if (section.has("distortion")) parameters.distortion = section.numbers("distortion");
  if (section.has("orientation"))
    parameters.orientation = read_camera_word(section, "orientation", kOrientations);
  if (section.has("port")) parameters.port = read_port(section);
  if (section.has("lens")) record = section.section("lens").all_texts();
  return parameters;
}

}  // namespace

void add_camera(const CameraParameters& parameters, const LensRecord& record,
                const UnknownKeys& unknown, YamlBlock& block) {
  block.add("model", std::string(to_string(parameters.model)));
  block.add("size", fmt::format("[{}, {}]", parameters.width_px, parameters.height_px));
  if (parameters.model == CameraModel::kOrthographic) {
    block.add("mm_per_px", yaml_number(parameters.mm_per_px));
  } else {
    block.add("fx", yaml_number(parameters.fx_px));
    block.add("fy", yaml_number(parameters.fy_px));
  }
  block.add("cx", yaml_number(parameters.cx_px));
  block.add("cy", yaml_number(parameters.cy_px));
  block.add("distortion", yaml_numbers(parameters.distortion));
  block.add("orientation", std::string(to_string(parameters.orientation)));
  if (parameters.port) block.add("port", in_braces(*parameters.port, unknown));
  YamlBlock lens("camera.lens");
  for (const auto& [key, value] : record) lens.add(key, yaml_text_or_number(value));
  lens.add_unknown(unknown);
  if (!lens.is_empty()) block.add("lens", lens.in_braces());
}

Result<CameraParameters> load_camera(const std::filesystem::path& path, LensRecord* record) {
  YamlFile file(path);
  CameraParameters parameters;
  LensRecord lens;
  bool is_wrapped = false;
  const Status read = file.load([&](YamlSection& top) {
    is_wrapped = top.has("camera");
    YamlSection section = is_wrapped ? top.section("camera") : top;
    parameters = read_camera(section, lens);
  });
  if (!read) return read.error();
  if (record != nullptr) *record = std::move(lens);
  const Status status = check_camera_range(parameters);
  if (status) return parameters;
  Error error = status.error();
  if (!is_wrapped) {
    const std::string key = error.where.english();
    error.where = key.substr(key.find('.') + 1);
  }
  return file.located(error);
}

std::string camera_fingerprint(const CameraParameters& parameters) {
  YamlBlock block("");
  add_camera(parameters, {}, {}, block);
  const std::string text = block.on_many_lines();
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return checksum.text();
}

Status save_camera(const std::filesystem::path& path, const CameraParameters& parameters,
                   const LensRecord& record) {
  if (const Status status = check_camera_range(parameters); !status) return status.error();
  YamlBlock block("");
  add_camera(parameters, record, {}, block);
  return write_file_atomically(path, block.on_many_lines());
}

RigidTransform read_pose(YamlSection section) {
  RigidTransform pose;
  const std::vector<double> at = section.numbers("translation_mm");
  if (at.size() != 3)
    section.refuse("translation_mm", en::say("must be three numbers: x, y, z in mm"), "");
  pose.translation_mm = {at[0], at[1], at[2]};
  const std::vector<double> turn = section.numbers("rotation");
  if (turn.size() != 4)
    section.refuse("rotation", en::say("must be four numbers: w, x, y, z of a unit quaternion"),
                   "");
  pose.rotation = {turn[0], turn[1], turn[2], turn[3]};
  return pose;
}

void add_pose(const RigidTransform& pose, YamlBlock& block) {
  const Eigen::Vector3d& at = pose.translation_mm;
  const Eigen::Quaterniond& turn = pose.rotation;
  block.add("translation_mm", yaml_numbers({at.x(), at.y(), at.z()}));
  block.add("rotation", yaml_numbers({turn.w(), turn.x(), turn.y(), turn.z()}));
}

std::optional<Error> pose_problem(const RigidTransform& pose, const std::string& key) {
  for (const double along : pose.translation_mm)
    if (!(along >= -1e4 && along <= 1e4))
      return Error{en::say("must be three numbers from -10000 to 10000"), key + ".translation_mm",
                   en::say("where the camera sits in the gripper, in mm")};
  if (const double norm = pose.rotation.norm(); !(norm >= 0.999 && norm <= 1.001))
    return Error{en::say("is no rotation: a quaternion w, x, y, z has the length 1"),
                 key + ".rotation",
                 en::say("[1.0, 0.0, 0.0, 0.0] for a camera that is not turned")};
  return std::nullopt;
}

namespace {

/// The words of the file, in the order of the enums, which count from 1.
using FingerWords = std::vector<std::string_view>;
const FingerWords kFaceKinds{"fin_ray", "flat"};
const FingerWords kPolarities{"bright", "dark", "auto"};
const FingerWords kMappingKinds{"polynomial", "moebius"};
const FingerWords kAlongs{"z", "normal", "projected"};

template <class E>
E read_word(YamlSection& section, const std::string& key, const FingerWords& words) {
  return static_cast<E>(section.choice(key, words) + 1);
}

Face read_face(YamlSection section) {
  Face face;
  face.kind = read_word<FaceKind>(section, "kind", kFaceKinds);
  if (face.kind == FaceKind::kFinRay)
    face.width_mm = section.number("width_mm", en::say("a length in mm"));
  face.layer_mm = section.number("layer_mm", en::say("a length in mm"));
  if (face.kind == FaceKind::kFlat && section.has("plane_z_mm"))
    face.plane_z_mm = section.number("plane_z_mm", en::say("a distance in mm"));
  return face;
}

MarkerRows read_markers(YamlSection section) {
  MarkerRows markers;
  markers.per_row = section.integer("per_row", 0, 64);
  if (section.has("polarity"))
    markers.polarity = read_word<Polarity>(section, "polarity", kPolarities);
  if (section.has("missing"))
    for (const double number : section.numbers("missing")) {
      if (number != std::floor(number) || std::abs(number) > 1000)
        section.refuse("missing", en::say("must be a list of integers"), en::say("[3, 9]"));
      markers.missing.push_back(static_cast<int>(number));
    }
  return markers;
}

Eigen::MatrixXd read_covariance(YamlSection& section) {
  const auto rows = section.rows("covariance");
  const std::size_t size = rows.size();
  if (!std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.size() == size; }))
    section.refuse("covariance", en::say("must have as many numbers in each row as there are rows"),
                   "");
  Eigen::MatrixXd covariance(size, size);
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      covariance(static_cast<int>(row), static_cast<int>(column)) = rows[row][column];
  return covariance;
}

/// Checks `powers`, which is for people: a contradiction means that the wrong line was edited.
void check_powers(YamlSection& section, const MappingParameters& parameters) {
  const std::vector<double> stated = section.numbers("powers");
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return;  // validate() will report the reason
  const std::vector<double> powers = mapping->powers();
  bool is_same = stated.size() == powers.size();
  double stated_scale = 0, x = 1;  // of the terms at the end of the domain
  for (double power : powers) stated_scale += std::abs(power) * x, x *= parameters.x_max;
  x = 1;
  for (std::size_t i = 0; is_same && i < powers.size(); ++i, x *= parameters.x_max)
    is_same = std::abs(stated[i] - powers[i]) * x <= 1e-6 * stated_scale;
  if (!is_same)
    section.refuse("powers", en::say("is not the curve that 'chebyshev' gives"),
                   en::say("remove this line: it is only for people to read"));
}

FaceVariation read_variation(YamlSection section) {
  FaceVariation variation;
  variation.part = {section.number("along", en::say("a fraction of the depth")),
                    section.number("across", en::say("a fraction of the depth"))};
  const auto read_pair = [&](const char* key) {
    const std::vector<double> numbers = section.numbers(key);
    if (numbers.size() != 2)
      section.refuse(key, en::say("must be two numbers: mm along and across the face"), "");
    return Eigen::Vector2d(numbers[0], numbers[1]);
  };
  variation.middle_mm = read_pair("middle_mm");
  variation.half_mm = read_pair("half_mm");
  return variation;
}

MappingParameters read_mapping(YamlSection& section) {
  MappingParameters parameters;
  parameters.kind = read_word<MappingKind>(section, "kind", kMappingKinds);
  if (section.has("along")) parameters.along = read_word<MappingAlong>(section, "along", kAlongs);
  const std::vector<double> domain = section.numbers("domain");
  if (domain.size() != 2 || domain[0] != 0)
    section.refuse("domain", en::say("must be two numbers, the first of them 0"),
                   en::say("for example [0.0, 0.62]"));
  parameters.x_max = domain[1];
  if (section.has("varies")) parameters.variation = read_variation(section.section("varies"));
  if (section.has("covariance")) parameters.covariance = read_covariance(section);
  if (parameters.kind == MappingKind::kMoebius) {
    parameters.a_mm = section.number("a_mm", en::say("a depth in mm"));
    parameters.b = section.number("b", en::say("without unit"));
  } else {
    parameters.chebyshev = section.numbers("chebyshev");
    if (section.has("powers")) check_powers(section, parameters);
  }
  return parameters;
}

CalibrationBasis read_basis(YamlSection section) {
  constexpr Limits kLength{0, 1000};
  constexpr int kMaxPresses = 1'000'000;
  CalibrationBasis basis;
  basis.ball_radii_mm = section.numbers("ball_radii_mm", kLength);
  // In one list, so that a search and replace of a face's numbers in the file skips these.
  const auto face = section.numbers("face_mm", 3, 3, {-1e6, 1e6});
  basis.width_mm = face[0], basis.layer_mm = face[1], basis.plane_z_mm = face[2];
  basis.camera = section.text("camera");
  basis.reference = section.text("reference");
  basis.positions = section.integer("positions", 0, kMaxPresses);
  const auto thirds = section.numbers("thirds", 3, 3, {0, kMaxPresses});
  for (std::size_t i = 0; i < basis.thirds.size(); ++i)
    basis.thirds[i] = static_cast<int>(thirds[i]);
  basis.position_leverage = section.number("position_leverage", {0, 1e6});
  const auto depths = section.numbers("depths_mm", 2, 2, kLength);
  basis.shallowest_mm = depths[0];
  basis.deepest_mm = depths[1];
  basis.scale_sd_mm = section.number("scale_sd_mm", kLength);
  basis.pixel_sd_mm = section.number("pixel_sd_mm", kLength);
  basis.halo_mm = section.number("halo_mm", kLength);
  basis.depth_per_radius = section.number("depth_per_radius", {-1000, 1000});
  basis.left_out = section.integer("left_out", 0, kMaxPresses);
  basis.is_complete = section.choice("complete", {"false", "true"}) == 1;
  if (!section.has("contradictions")) return basis;
  const auto kinds = section.texts("contradictions");
  const auto rows = section.rows("contradictions_mm");
  if (rows.size() != kinds.size())
    section.refuse("contradictions_mm", en::say("must have a row for each contradiction"), "");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (rows[i].size() != 5)
      section.refuse("contradictions_mm", en::say("must hold five numbers in each row"), "");
    basis.contradictions.push_back({kinds[i], static_cast<int>(std::clamp(rows[i][0], 0.0, 1e6)),
                                    static_cast<int>(std::clamp(rows[i][1], 0.0, 1e6)), rows[i][2],
                                    rows[i][3], rows[i][4]});
  }
  return basis;
}

std::optional<MappingRecord> read_record(YamlSection& section) {
  const std::array keys{"method",    "presses",  "residual_mm",   "held_out_mm",
                        "spread_mm", "pixel_mm", "degree_choice", "basis"};
  if (std::none_of(keys.begin(), keys.end(), [&](const char* key) { return section.has(key); }))
    return std::nullopt;
  MappingRecord record;
  if (section.has("method")) record.method = section.text("method");
  if (section.has("presses")) record.presses = section.texts("presses");
  if (section.has("residual_mm"))
    record.residual_mm = section.number("residual_mm", en::say("in mm"));
  if (section.has("held_out_mm"))
    record.held_out_mm = section.number("held_out_mm", en::say("in mm"));
  if (section.has("spread_mm")) record.spread_mm = section.number("spread_mm", en::say("in mm"));
  if (section.has("pixel_mm")) record.pixel_mm = section.number("pixel_mm", en::say("in mm"));
  if (section.has("degree_choice")) record.degree_choice = section.text("degree_choice");
  if (section.has("basis")) record.basis = read_basis(section.section("basis"));
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
      const std::vector<double> positions = section.numbers("places");
      if (positions.size() != 2)
        section.refuse("places", en::say("must be two numbers: a column in px, a step in mm"), "");
      files.positions = EdgePositions{positions[0], positions[1]};
    }
  }
  return files;
}

ContactSettings read_contact(YamlSection section) {
  ContactSettings contact;
  contact.threshold_px = section.number("threshold_px", en::say("a sum of offsets in pixels"));
  for (const std::vector<double>& row : section.rows("rest_markers")) {
    if (row.size() != 2)
      section.refuse("rest_markers", en::say("must hold two numbers for each marker"),
                     en::say("[[u, v], ...]"));
    contact.rest_markers.emplace_back(row[0], row[1]);
  }
  return contact;
}

/// Checks the form of the values; Finger::validate() checks the values.
Finger read_finger(YamlSection& top) {
  Finger finger;
  if (const std::string format = top.text("format"); format != Finger::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)),
               en::say("a newer version of this program, or '{}'", std::string(Finger::kFormat)));
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
  }
  if (top.has("reference"))
    finger.reference = read_reference(top.section("reference"), finger.face.kind);
  if (top.has("contact")) finger.contact = read_contact(top.section("contact"));
  if (top.has("force")) {
    YamlSection force = top.section("force");
    finger.force_model = force.text("model");
    if (finger.force_model.empty())
      force.refuse("model", en::say("must name a file"), en::say("force.yaml"));
  }
  if (top.has("gripper_from_camera"))
    finger.gripper_from_camera = read_pose(top.section("gripper_from_camera"));
  if (top.has("provenance")) finger.provenance = top.section("provenance").all_texts();
  return finger;
}

// Writing.

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

/// A valid finger as a file. `unknown`: unknown keys of its original file.
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

}  // namespace

struct Finger::Unknown {
  UnknownKeys keys;
};

Result<Finger> Finger::load(const std::filesystem::path& folder, std::vector<Message>* warnings) {
  const std::filesystem::path path = folder / kFileName;
  const auto content = read_file(path, YamlFile::kMaxBytes);
  if (!content) return content.error();
  return parse(*content, path, warnings);
}

Result<Finger> Finger::parse(const std::string& yaml, const std::filesystem::path& origin,
                             std::vector<Message>* warnings) {
  YamlFile file(origin);
  Finger finger;
  const Status read = file.read(yaml, [&](YamlSection& top) { finger = read_finger(top); });
  if (!read) return read.error();
  if (const Status status = finger.validate(); !status) return file.located(status.error());
  finger.unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown())});
  if (warnings != nullptr) {
    *warnings = std::move(file.warnings());
    for (const Error& number : finger.implausible())
      warnings->push_back(file.located(number).message());
  }
  return finger;
}

Result<std::string> Finger::to_yaml() const {
  static const UnknownKeys kNone;
  if (const Status status = validate(); !status) return status.error();
  return finger_text(*this, unknown_ ? unknown_->keys : kNone);
}

Status Finger::save(const std::filesystem::path& folder) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(folder / kFileName, *text);
}

}  // namespace alltact
