#include "core/finger/finger.h"

#include "core/base/message.h"
#include "core/base/typed_number.h"
#include "core/camera/camera.h"
#include "core/finger/finger_yaml.h"

#include <array>

namespace alltact {
namespace {

/// False for NaN.
bool is_in(double value, double low, double high) { return value >= low && value <= high; }

std::optional<Error> face_problem(const Face& face, bool is_perspective) {
  if (auto refused = kLayerThickness.refusal(face.layer_mm))
    return Error{std::move(*refused), std::string("face.layer_mm"),
                 en::say("the thickness of the translucent layer in mm, for example 1.5")};
  if (face.kind == FaceKind::kFinRay) {
    if (auto refused = kFaceWidth.refusal(face.width_mm))
      return Error{std::move(*refused), std::string("face.width_mm"),
                   en::say("the distance between the two edges of the view face in mm")};
    if (!is_perspective)
      return Error{en::say("a fin_ray needs a perspective camera: its shape is computed from it"),
                   std::string("camera.model"), en::say("pinhole, brown or fisheye")};
    return std::nullopt;
  }
  if (!is_in(face.plane_z_mm, is_perspective ? 1e-3 : -1e4, 1e4))
    return Error{
        is_perspective
            ? en::say("must be above 0 and at most 10000: the face is in front of the camera")
            : en::say("must be a number from -10000 to 10000"),
        std::string("face.plane_z_mm"), en::say("the distance of the face from the camera in mm")};
  return std::nullopt;
}

std::optional<Error> marker_problem(const MarkerRows& markers, FaceKind kind) {
  if (kind == FaceKind::kFlat) {
    if (markers.per_row == 0) return std::nullopt;
    return Error{en::say("a flat sensor has no markers"), std::string("markers.per_row"),
                 en::say("remove the block 'markers'")};
  }
  if (!(markers.per_row >= 0 && markers.per_row <= 64))
    return Error{en::say("must be an integer from 0 to 64"), std::string("markers.per_row"),
                 en::say("the number of dots on one side face, 0 for a finger without")};
  int lowest = 0;
  for (const int number : markers.missing) {
    if (number < lowest || number >= 2 * markers.per_row)
      return Error{en::say("must be numbers from 0 to {}, ascending", 2 * markers.per_row - 1),
                   std::string("markers.missing"), en::say("record the reference again")};
    lowest = number + 1;
  }
  return std::nullopt;
}

/// The maximum depth of a press is the layer's thickness; along z, on a face inclined by 75
/// degrees, four times that.
std::optional<Error> mapping_problem(const MappingParameters& parameters, double layer_mm) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return mapping.error();
  // Narrower domains never occur in a calibration, and their powers of x overflow.
  constexpr double kMinDomain = 1e-3;
  if (parameters.x_max < kMinDomain)
    return Error{en::say("must be a number from {} to {}", kMinDomain, 1),
                 std::string("mapping.domain"), en::say("calibrate again")};
  constexpr double kMaxLayers = 4;
  const double deepest_mm = mapping->depth_mm(mapping->x_max());
  if (deepest_mm <= kMaxLayers * layer_mm) return std::nullopt;
  return Error{
      en::say("gives depths up to {:.3g} mm in a layer of {:g} mm", deepest_mm, layer_mm),
      std::string(parameters.kind == MappingKind::kMoebius ? "mapping.a_mm" : "mapping.chebyshev"),
      en::say("calibrate again")};
}

std::optional<Error> basis_problem(const CalibrationBasis& basis) {
  bool is_possible = is_in(basis.plane_z_mm, -1e6, 1e6) && is_in(basis.position_leverage, 0, 1e6) &&
                     is_in(basis.depth_per_radius, -1000, 1000) &&
                     is_in(basis.undetected_spread, 0, 1) && basis.positions >= 0 &&
                     basis.left_out >= 0;
  for (const double length_mm :
       {basis.layer_mm, basis.width_mm, basis.shallowest_mm, basis.deepest_mm, basis.scale_sd_mm,
        basis.pixel_sd_mm, basis.halo_mm})
    is_possible = is_possible && is_in(length_mm, 0, 1000);
  for (const double radius_mm : basis.ball_radii_mm)
    is_possible = is_possible && is_in(radius_mm, 0, 1000);
  for (const int third : basis.thirds) is_possible = is_possible && third >= 0;
  for (const RecordedContradiction& one : basis.contradictions)
    for (const double mm : {one.given_mm, one.measured_mm, one.measured_to_mm})
      is_possible = is_possible && is_in(mm, -1e6, 1e6);
  if (is_possible) return std::nullopt;
  return Error{en::say("holds a number that no calibration has"), std::string("mapping.basis"),
               en::say("calibrate again")};
}

std::optional<Error> record_problem(const MappingRecord& record) {
  for (const auto& [value, key] : {std::pair{record.residual_mm, "mapping.residual_mm"},
                                   {record.held_out_mm, "mapping.held_out_mm"},
                                   {record.spread_mm, "mapping.spread_mm"},
                                   {record.pixel_mm, "mapping.pixel_mm"}})
    if (!is_in(value, 0, 1000))
      return Error{en::say("must be a number from 0 to 1000"), std::string(key),
                   en::say("calibrate again")};
  return record.basis ? basis_problem(*record.basis) : std::nullopt;
}

std::optional<Error> file_problem(const std::string& name, const std::string& key) {
  const std::filesystem::path path(name);
  const bool leads_out = path.is_absolute() || *path.lexically_normal().begin() == "..";
  if (!name.empty() && !leads_out && path.has_filename() && name.find('\0') == std::string::npos)
    return std::nullopt;
  return Error{en::say("'{}' is not a file in the finger's folder", printable(name)), key,
               en::say("copy the file into the folder and give its name only")};
}

std::optional<Error> reference_problem(const ReferenceFiles& files) {
  if (files.video.empty() && files.markers.empty())
    return file_problem(files.image, "reference.image");
  if (const auto& positions = files.positions;
      positions &&
      !(is_in(positions->from_u_px, -1e5, 1e5) && is_in(positions->step_mm, 1e-3, 500)))
    return Error{en::say("must be a column of the image and a step of 0.001 to 500 mm"),
                 std::string("reference.places"), en::say("record the reference again")};
  if (!files.image.empty())
    return Error{en::say("there is either a video with its markers or one image, not both"),
                 std::string("reference.image"), en::say("remove one of them")};
  if (auto problem = file_problem(files.video, "reference.video")) return problem;
  return file_problem(files.markers, "reference.markers");
}

std::optional<Error> contact_problem(const ContactSettings& contact, int marker_count,
                                     const CameraParameters& camera) {
  if (!(contact.threshold_px > 0 && contact.threshold_px <= 1e6))
    return Error{en::say("must be above 0 and at most 1000000"),
                 std::string("contact.threshold_px"), en::say("record the reference again")};
  const std::string key = "contact.rest_markers";
  if (static_cast<int>(contact.rest_markers.size()) != marker_count)
    return Error{en::say("holds {} positions, but there are {} markers",
                         contact.rest_markers.size(), marker_count),
                 key, en::say("record the reference again")};
  // Estimated positions of hidden markers may lie a little outside; raw images may be rotated.
  const double side = std::max(camera.width_px, camera.height_px);
  for (const Eigen::Vector2d& marker : contact.rest_markers)
    if (!is_in(marker.x(), -side, 2 * side) || !is_in(marker.y(), -side, 2 * side))
      return Error{en::say("holds a position far outside the image"), key,
                   en::say("record the reference again")};
  return std::nullopt;
}

}  // namespace

std::vector<Error> Finger::implausible() const {
  std::vector<Error> all = implausible_camera(camera);
  const auto check = [&all](const Quantity& quantity, double value) {
    if (auto warning = quantity.warning(value))
      all.push_back({std::move(*warning), "face." + std::string(quantity.key), ""});
  };
  check(kLayerThickness, face.layer_mm);
  if (face.kind == FaceKind::kFinRay)
    check(kFaceWidth, face.width_mm);
  else if (camera.model != CameraModel::kOrthographic)
    check(kPlaneDistance, face.plane_z_mm);
  return all;
}

Status Finger::validate() const {
  if (name.empty() || name.size() > 200)
    return Error{en::say("must be a text of 1 to 200 characters"), std::string("name"),
                 en::say("what is written on the finger")};
  if (const Status status = check_camera_range(camera); !status) return status.error();
  const bool is_perspective = camera.model != CameraModel::kOrthographic;
  if (auto problem = face_problem(face, is_perspective)) return *problem;
  if (auto problem = marker_problem(markers, face.kind)) return *problem;
  if (mapping)
    if (auto problem = mapping_problem(*mapping, face.layer_mm)) return *problem;
  if (mapping_record) {
    if (!mapping)
      return Error{en::say("states how a mapping was made, but there is none"),
                   std::string("mapping"), en::say("calibrate")};
    if (auto problem = record_problem(*mapping_record)) return *problem;
  }
  if (reference)
    if (auto problem = reference_problem(*reference)) return *problem;
  if (contact)
    if (auto problem = contact_problem(*contact, marker_count(), camera)) return *problem;
  if (!force_model.empty())
    if (auto problem = file_problem(force_model, "force.model")) return *problem;
  if (gripper_from_camera)
    if (auto problem = pose_problem(*gripper_from_camera, "gripper_from_camera")) return *problem;
  return {};
}

std::string_view to_string(PushedFace face) {
  constexpr std::array<std::string_view, 4> words{"contact", "back", "upper", "lower"};
  return words[static_cast<std::size_t>(face) - 1];
}

}  // namespace alltact
