#include "core/simulation/scene.h"

#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/simulation/scene_content.h"

#include <numbers>
#include <set>

namespace alltact {

namespace {

constexpr std::size_t kLargestScene = std::size_t{1} << 20;

CameraParameters read_camera(Parameters map) {
  CameraParameters camera;
  camera.model =
      *camera_model_from(map.word("model", {"pinhole", "brown", "fisheye", "orthographic"}));
  const auto size = map.numbers("size", 2, 2);
  for (const double length : size)
    if (length != std::floor(length) || length < 16 || length > 16384)
      map.refuse("size", "this is not [width, height]", "whole numbers from 16 to 16384");
  camera.width_px = static_cast<int>(size[0]);
  camera.height_px = static_cast<int>(size[1]);
  camera.cx_px = map.number("cx", {-1e5, 1e5});
  camera.cy_px = map.number("cy", {-1e5, 1e5});
  if (camera.model == CameraModel::kOrthographic) {
    camera.mm_per_px = map.number("mm_per_px", strength_up_to(100));
  } else {
    camera.fx_px = map.number("fx", strength_up_to(1e6));
    camera.fy_px = map.number("fy", strength_up_to(1e6));
  }
  if (map.has("distortion")) camera.distortion = map.numbers("distortion", 0, 5);
  return camera;
}

Face read_face(Parameters map) {
  Face face;
  face.kind = map.word("kind", {"fin_ray", "flat"}) == "flat" ? FaceKind::kFlat : FaceKind::kFinRay;
  face.layer_mm = map.number("layer_mm", strength_up_to(50));
  if (face.kind == FaceKind::kFinRay)
    face.width_mm = map.number("width_mm", strength_up_to(500));
  else
    face.plane_z_mm = map.number("plane_z_mm", {0.1, 10000});
  return face;
}

MarkerRows read_markers(Parameters map) {
  MarkerRows rows;
  rows.per_row = map.integer("per_row", 2, 64);
  rows.polarity =
      map.word("polarity", {"bright", "dark"}) == "dark" ? Polarity::kDark : Polarity::kBright;
  return rows;
}

void read_untouched(Parameters map, Scene::Content& content) {
  content.base_mm.x() = map.number("x_mm", {-1000, 1000});
  content.base_mm.y() = map.number_or("y_mm", 0, {-1000, 1000});
  content.base_mm.z() = map.number("z_mm", {1, 1000});
  content.incline_rad = map.number("incline_deg", {-75, 75}) * std::numbers::pi / 180;
  content.length_mm = map.number("length_mm", {1, 1000});
}

void read_effects(Parameters& scene, Scene::Content& content) {
  std::set<std::string> seen;
  for (Parameters& map : scene.maps("effects")) {
    const std::string use = map.text("use");
    const auto kinds = effect_kinds();
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto* k) { return k->name == use; });
    if (kind == kinds.end()) {
      std::vector<std::string> names;
      for (const auto* k : kinds) names.push_back(k->name);
      std::sort(names.begin(), names.end());
      map.refuse("use",
                 fmt::format("there is no effect '{}'", printable(use)),
                 fmt::format("one of {}", fmt::join(names, ", ")));
      return;
    }
    if (!seen.insert(use).second)
      map.refuse("use", fmt::format("the effect '{}' is named twice", use), "remove one of them");
    map.rename(use);
    content.effects.push_back({*kind, (*kind)->make(map), map.where("")});
  }
  std::stable_sort(
      content.effects.begin(), content.effects.end(), [](const auto& a, const auto& b) {
        return std::pair(a.kind->stage, a.kind->rank) < std::pair(b.kind->stage, b.kind->rank);
      });
}

Result<std::shared_ptr<const Scene::Content>> read_scene(const YAML::Node& root,
                                                         const std::string& origin) {
  if (!root.IsMap())
    return Error{"this is not a scene", origin, "name, why, finger, frames and effects"};
  auto content = std::make_shared<Scene::Content>();
  Parameters scene(root, origin, "");
  content->name = scene.text("name");
  content->why = scene.text("why");
  content->frame_count = scene.integer_or("frames", 1, 1, 1000000);
  content->frames_per_s = scene.number_or("frames_per_s", 30, {0.1, 10000});
  Parameters finger = scene.map("finger");
  content->finger.name = content->name;
  content->finger.camera = read_camera(finger.map("camera"));
  content->finger.face = read_face(finger.map("face"));
  if (finger.has("markers")) content->finger.markers = read_markers(finger.map("markers"));
  if (content->finger.face.kind == FaceKind::kFinRay)
    read_untouched(scene.map("untouched"), *content);
  if (scene.has("motion")) {
    Parameters motion = scene.map("motion");
    content->motion = Motion::read(motion);
  }
  read_effects(scene, *content);
  if (Status status = scene.status(); !status) return status.error();
  return std::shared_ptr<const Scene::Content>(std::move(content));
}

}  // namespace

Result<Scene> Scene::load(const std::filesystem::path& file) {
  auto text = read_file(file, kLargestScene);
  if (!text) return text.error();
  return parse(*text, file.string());
}

Result<Scene> Scene::parse(std::string_view yaml, const std::string& origin) {
  try {
    auto content = read_scene(YAML::Load(std::string(yaml)), origin);
    if (!content) return content.error();
    Scene scene;
    scene.content_ = *content;
    return scene;
  } catch (const YAML::Exception& e) {
    return Error{e.msg, fmt::format("{}:{}", origin, e.mark.line + 1), "mend the YAML there"};
  } catch (const cv::Exception& e) {
    return Error{e.err, origin, ""};
  }
}

const std::string& Scene::name() const {
  return content_->name;
}
const std::string& Scene::why() const {
  return content_->why;
}

}  // namespace alltact
