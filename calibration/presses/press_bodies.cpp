#include "calibration/presses/press_bodies.h"

#include "core/mesh/mesh_distance.h"

#include <algorithm>
#include <memory>

#include <Eigen/Geometry>

namespace alltact {
namespace {

namespace fs = std::filesystem;

// Of what is pressed into a finger: its longest side.
constexpr double kSmallestMm = 1, kLargestMm = 500;

}  // namespace

Result<KnownBody> load_body(const fs::path& file) {
  const auto mesh = read_mesh(file);
  if (!mesh) return mesh.error();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : mesh->points) box.extend(point);
  const double longest_mm = box.sizes().maxCoeff();
  if (!(longest_mm >= kSmallestMm && longest_mm <= kLargestMm))
    return Error{en::say("in millimetres, this body would be {:.3g} mm long", longest_mm),
                 file.string(), en::say("exporting its mesh in millimetres")};
  auto shape = MeshDistance::create(*mesh);
  if (!shape) {
    Error error = shape.error();
    error.where = file.string();
    return error;
  }
  return KnownBody{file.filename().string(),
                   std::make_shared<const MeshDistance>(std::move(shape).value())};
}

fs::path body_file(const fs::path& finger_folder, const std::string& file) {
  return finger_folder / file;  // an absolute path replaces the folder
}

Result<PressBodies> load_bodies(const PressSet& press_set, const fs::path& finger_folder) {
  PressBodies bodies;
  for (const auto& [name, note] : press_set.notes) {
    if (!note.body || note.excluded || bodies.contains(*note.body)) continue;
    auto body = load_body(body_file(finger_folder, *note.body));
    if (!body) return body.error();
    bodies.emplace(*note.body, std::move(body).value());
  }
  return bodies;
}

void apply_note(const PressSet& press_set, const PressBodies& bodies, Press& press) {
  const PressNote& note = press_set.of(press.name);
  press.ball_radius_mm = press_set.radius_of(press.name);
  press.ball_mm = note.ball_mm;
  press.given_depth = note.depth;
  press.step_mm = note.step_mm;
  press.body.reset();
  if (!note.body) return;
  if (const auto found = bodies.find(*note.body); found != bodies.end()) press.body = found->second;
}

}  // namespace alltact
