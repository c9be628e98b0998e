#include "core/finger/finger_yaml.h"

#include "core/base/atomic_file.h"
#include "core/base/fields.h"
#include "core/base/message.h"
#include "core/camera/camera_file.h"
#include "core/finger/finger.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
void describe(Fields& fields, RigidTransform& pose) {
  Eigen::Vector3d& at = pose.translation_mm;
  Eigen::Quaterniond& turn = pose.rotation;
  fields.numbers("translation_mm", {&at.x(), &at.y(), &at.z()},
                 en::say("must be three numbers: x, y, z in mm"));
  fields.numbers("rotation", {&turn.w(), &turn.x(), &turn.y(), &turn.z()},
                 en::say("must be four numbers: w, x, y, z of a unit quaternion"));
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

const EnumWords kFaceKinds{"fin_ray", "flat"};
const EnumWords kPolarities{"bright", "dark", "auto"};
const EnumWords kMappingKinds{"polynomial", "moebius"};

constexpr Limits kLength{0, 1000};
constexpr int kMaxPresses = 1'000'000;

/// Checks `powers`, which is for people: a contradiction means that the wrong line was edited.
void check_powers(const Fields& fields, const std::vector<double>& stated,
                  const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return;  // validate() will report the reason
  const std::vector<double> powers = mapping->powers();
  bool is_same = stated.size() == powers.size();
  double stated_scale = 0, x = 1;  // of the terms at the end of the domain
  for (double power : powers) stated_scale += std::abs(power) * x, x *= parameters.x_max;
  x = 1;
  for (std::size_t i = 0; is_same && i < powers.size(); ++i, x *= parameters.x_max)
    is_same = std::abs(stated[i] - powers[i]) * x <= 1e-6 * stated_scale;
  fields.demand(is_same, "powers", en::say("is not the curve that 'chebyshev' gives"),
                en::say("remove this line: it is only for people to read"));
}

void describe_covariance(Fields& fields, Eigen::MatrixXd& covariance) {
  const FieldKey key = may("covariance", covariance.size() != 0);
  if (!fields.has(key)) return;
  std::vector<std::vector<double>> rows;
  for (const auto& row : covariance.rowwise()) rows.emplace_back(row.begin(), row.end());
  fields.rows(key, rows);
  if (!fields.is_reading()) return;
  const std::size_t size = rows.size();
  covariance.resize(static_cast<int>(size), static_cast<int>(size));
  for (std::size_t row = 0; row < size; ++row) {
    fields.demand(rows[row].size() == size, key.name,
                  en::say("must have as many numbers in each row as there are rows"), "");
    for (std::size_t column = 0; column < size; ++column)
      covariance(static_cast<int>(row), static_cast<int>(column)) = rows[row][column];
  }
}

void describe_contradictions(Fields& fields, std::vector<RecordedContradiction>& all) {
  std::vector<std::string> kinds;
  std::vector<std::vector<double>> rows;
  for (const RecordedContradiction& one : all) {
    kinds.push_back(one.kind);
    rows.push_back({static_cast<double>(one.presses), static_cast<double>(one.of), one.given_mm,
                    one.measured_mm, one.measured_to_mm});
  }
  const FieldKey key = may("contradictions", !all.empty());
  if (!fields.has(key)) return;
  fields.texts(key, kinds);
  fields.rows("contradictions_mm", rows);
  fields.demand(rows.size() == kinds.size(), "contradictions_mm",
                en::say("must have a row for each contradiction"), "");
  all.clear();
  const auto count = [](double number) { return static_cast<int>(std::clamp(number, 0.0, 1e6)); };
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::vector<double>& row = rows[i];
    fields.demand(row.size() == 5, "contradictions_mm",
                  en::say("must hold five numbers in each row"), "");
    all.push_back({kinds[i], count(row[0]), count(row[1]), row[2], row[3], row[4]});
  }
}

}  // namespace

static void describe(Fields& fields, Face& face) {
  fields.choice("kind", face.kind, kFaceKinds);
  if (face.kind == FaceKind::kFinRay)
    fields.number("width_mm", face.width_mm, en::say("a length in mm"));
  fields.number("layer_mm", face.layer_mm, en::say("a length in mm"));
  if (face.kind == FaceKind::kFlat)
    fields.number(may("plane_z_mm"), face.plane_z_mm, en::say("a distance in mm"));
}

static void describe(Fields& fields, MarkerRows& markers) {
  fields.integer("per_row", markers.per_row, 0, 64);
  fields.choice(may("polarity"), markers.polarity, kPolarities);
  fields.integers(may("missing", !markers.missing.empty()), markers.missing, 1000, std::nullopt,
                  en::say("must be a list of integers"), en::say("[3, 9]"));
}

static void describe(Fields& fields, FaceVariation& variation) {
  const Message refusal = en::say("must be two numbers: mm along and across the face");
  fields.number("along", variation.part.x(), en::say("a fraction of the depth"));
  fields.number("across", variation.part.y(), en::say("a fraction of the depth"));
  fields.numbers("middle_mm", {&variation.middle_mm.x(), &variation.middle_mm.y()}, refusal);
  fields.numbers("half_mm", {&variation.half_mm.x(), &variation.half_mm.y()}, refusal);
}

static void describe(Fields& fields, LightSpread& spread) {
  fields.number("optical_thickness", spread.optical_thickness, en::say("without unit"));
  fields.number("optical_thickness_sd", spread.optical_thickness_sd, en::say("without unit"));
  fields.number("width_factor", spread.width_factor, en::say("without unit"));
  fields.number("b_straight", spread.b_straight, en::say("without unit"));
  fields.number("log_b_along", spread.log_b_along, en::say("without unit"));
  fields.number("middle_mm", spread.middle_mm, en::say("in mm"));
  fields.number("half_mm", spread.half_mm, en::say("in mm"));
}

static void describe(Fields& fields, MappingParameters& mapping) {
  fields.choice("kind", mapping.kind, kMappingKinds);
  fields.choice(may("along"), mapping.along, words_up_to(MappingAlong::kProjected));
  double start = 0;
  std::vector<double> powers;
  const Message domain = en::say("must be two numbers, the first of them 0"),
                example = en::say("for example [0.0, 0.62]");
  fields.numbers("domain", {&start, &mapping.x_max}, domain, example);
  fields.demand(start == 0, "domain", domain, example);
  if (mapping.kind == MappingKind::kMoebius) {
    fields.number("a_mm", mapping.a_mm, en::say("a depth in mm"));
    fields.number("b", mapping.b, en::say("without unit"));
  } else {
    fields.numbers("chebyshev", mapping.chebyshev);
    if (!fields.is_reading()) powers = Mapping::create(mapping)->powers();
    fields.numbers(may("powers"), powers);
  }
  fields.section(may("varies", !mapping.variation.is_none()), mapping.variation);
  fields.section(may("spread", !mapping.spread.is_local()), mapping.spread);
  describe_covariance(fields, mapping.covariance);
  const bool is_polynomial = mapping.kind == MappingKind::kPolynomial;
  if (fields.is_reading() && is_polynomial && fields.has(may("powers")))
    check_powers(fields, powers, mapping);
}

static void describe(Fields& fields, CalibrationBasis& basis) {
  fields.numbers("ball_radii_mm", basis.ball_radii_mm, kLength);
  // In one list, so that a search and replace of a face's numbers in the file skips these.
  fields.numbers("face_mm", {&basis.width_mm, &basis.layer_mm, &basis.plane_z_mm}, {-1e6, 1e6});
  fields.quoted("camera", basis.camera);
  fields.quoted("reference", basis.reference);
  fields.integer("positions", basis.positions, 0, kMaxPresses);
  fields.integers("thirds", basis.thirds, {0, kMaxPresses});
  fields.number("position_leverage", basis.position_leverage, {0, 1e6});
  fields.numbers("depths_mm", {&basis.shallowest_mm, &basis.deepest_mm}, kLength);
  fields.number("scale_sd_mm", basis.scale_sd_mm, kLength);
  fields.number("pixel_sd_mm", basis.pixel_sd_mm, kLength);
  fields.number("halo_mm", basis.halo_mm, kLength);
  fields.number(may("undetected_spread", basis.undetected_spread < 1), basis.undetected_spread,
                {0, 1});
  fields.number("depth_per_radius", basis.depth_per_radius, {-1000, 1000});
  fields.integer("left_out", basis.left_out, 0, kMaxPresses);
  fields.flag("complete", basis.is_complete);
  describe_contradictions(fields, basis.contradictions);
}

/// Every key may be absent: without any of them there is no record.
static void describe(Fields& fields, MappingRecord& record) {
  fields.text(may("method"), record.method);
  fields.texts(may("presses"), record.presses);
  fields.number(may("residual_mm"), record.residual_mm, en::say("in mm"));
  fields.number(may("held_out_mm"), record.held_out_mm, en::say("in mm"));
  fields.number(may("spread_mm", record.spread_mm > 0), record.spread_mm, en::say("in mm"));
  fields.number(may("pixel_mm", record.pixel_mm > 0), record.pixel_mm, en::say("in mm"));
  fields.text(may("degree_choice"), record.degree_choice);
  fields.section(may("basis"), record.basis);
}

static void describe(Fields& fields, ContactSettings& contact) {
  fields.number("threshold_px", contact.threshold_px, en::say("a sum of offsets in pixels"));
  fields.rows(
      "rest_markers", contact.rest_markers,
      [](Eigen::Vector2d& marker) {
        return std::array{&marker.x(), &marker.y()};
      },
      kAnyNumber, en::say("must hold two numbers for each marker"), en::say("[[u, v], ...]"));
}

namespace {

void describe_reference(Fields& fields, ReferenceFiles& files, FaceKind kind) {
  const bool is_image =
      fields.has(may("image", !files.image.empty())) ||
      (fields.is_reading() && kind == FaceKind::kFlat && !fields.has(may("video")));
  if (is_image) return fields.text("image", files.image);
  fields.text("video", files.video);
  fields.text("markers", files.markers);
  if (fields.has(may("places"), files.positions))
    fields.numbers("places", {&files.positions->from_u_px, &files.positions->step_mm},
                   en::say("must be two numbers: a column in px, a step in mm"));
}

void describe_mapping(Fields& fields, Finger& finger) {
  describe(fields, *finger.mapping);
  const bool had_record = finger.mapping_record.has_value();
  if (!fields.is_reading() && !had_record) return;
  if (!had_record) finger.mapping_record.emplace();
  const int before = fields.found();
  describe(fields, *finger.mapping_record);
  if (fields.is_reading() && fields.found() == before) finger.mapping_record.reset();
}

}  // namespace

/// Checks the form of the values; Finger::validate() checks the values.
static void describe(Fields& fields, Finger& finger) {
  using Layout = Fields::Layout;
  fields.format(Finger::kFormat,
                en::say("a newer version of this program, or '{}'", std::string(Finger::kFormat)));
  fields.text("name", finger.name);
  CameraFile camera{finger.camera, finger.lens_record, {}, {}};
  fields.section("camera", camera, Layout::kLines);
  finger.camera = camera.parameters, finger.lens_record = camera.lens;
  fields.section("face", finger.face, Layout::kLines);
  const bool is_fin_ray = finger.face.kind == FaceKind::kFinRay;
  fields.section(may("markers", is_fin_ray).required_if(is_fin_ray), finger.markers);
  if (fields.has(may("mapping"), finger.mapping))
    fields.section("mapping", Layout::kLines,
                   [&](Fields& mapping) { describe_mapping(mapping, finger); });
  if (fields.has(may("reference"), finger.reference))
    fields.section("reference", Layout::kBraces, [&](Fields& reference) {
      describe_reference(reference, *finger.reference, finger.face.kind);
    });
  fields.section(may("contact"), finger.contact, Layout::kLines);
  fields.section(may("force", !finger.force_model.empty()), Layout::kBraces, [&](Fields& force) {
    force.text("model", finger.force_model);
    force.demand(!finger.force_model.empty(), "model", en::say("must name a file"),
                 en::say("force.yaml"));
  });
  fields.section(may("gripper_from_camera"), finger.gripper_from_camera);
  fields.texts_by_name("provenance", finger.provenance, Layout::kLines);
}

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
  auto finger = read_fields<Finger>(file, yaml);
  if (!finger) return finger;
  if (const Status status = finger->validate(); !status) return file.located(status.error());
  finger->unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown())});
  if (warnings != nullptr) {
    *warnings = std::move(file.warnings());
    for (const Error& number : finger->implausible())
      warnings->push_back(file.located(number).message());
  }
  return finger;
}

Result<std::string> Finger::to_yaml() const {
  static const UnknownKeys kNone;
  if (const Status status = validate(); !status) return status.error();
  return fields_text(*this, unknown_ ? unknown_->keys : kNone);
}

Status Finger::save(const std::filesystem::path& folder) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(folder / kFileName, *text);
}

}  // namespace alltact
