#include "core/simulation/scene.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/numerics/philox.h"

#include <map>
#include <numbers>

namespace alltact {

namespace {

constexpr std::size_t kLargestScene = std::size_t{1} << 20;

CameraParameters read_camera(YamlSection section) {
  CameraParameters camera;
  const std::vector<std::string_view> models{"pinhole", "brown", "fisheye", "orthographic"};
  camera.model = *camera_model_from(models[section.choice("model", models)]);
  const auto size = section.numbers("size", 2, 2, {16, 16384});
  for (const double length : size)
    if (length != std::floor(length))
      section.refuse("size", en::say("this is not [width, height]"),
                     en::say("integers from 16 to 16384"));
  camera.width_px = static_cast<int>(size[0]);
  camera.height_px = static_cast<int>(size[1]);
  camera.cx_px = section.number("cx", {-1e5, 1e5});
  camera.cy_px = section.number("cy", {-1e5, 1e5});
  if (camera.model == CameraModel::kOrthographic) {
    camera.mm_per_px = section.number("mm_per_px", strength_up_to(100));
  } else {
    camera.fx_px = section.number("fx", strength_up_to(1e6));
    camera.fy_px = section.number("fy", strength_up_to(1e6));
  }
  if (const auto made = Camera::create(camera); !made)
    section.refuse("", made.error().what, made.error().advice);
  return camera;
}

Face read_face(YamlSection section) {
  Face face;
  face.kind =
      section.choice("kind", {"fin_ray", "flat"}) == 1 ? FaceKind::kFlat : FaceKind::kFinRay;
  face.layer_mm = section.number("layer_mm", strength_up_to(50));
  if (face.kind == FaceKind::kFinRay)
    face.width_mm = section.number("width_mm", strength_up_to(500));
  else
    face.plane_z_mm = section.number("plane_z_mm", {0.1, 10000});
  return face;
}

MarkerRows read_markers(YamlSection section) {
  MarkerRows rows;
  rows.per_row = section.integer("per_row", 2, 64);
  rows.polarity =
      section.choice("polarity", {"bright", "dark"}) == 1 ? Polarity::kDark : Polarity::kBright;
  return rows;
}

void read_untouched(YamlSection section, Scene& scene) {
  scene.base_mm.x() = section.number("x_mm", {-1000, 1000});
  scene.base_mm.y() = section.number_or("y_mm", 0, {-1000, 1000});
  scene.base_mm.z() = section.number("z_mm", {1, 1000});
  scene.incline_rad = section.number("incline_deg", {-75, 75}) * std::numbers::pi / 180;
  scene.length_mm = section.number("length_mm", {1, 1000});
}

const EffectKind* read_kind(YamlSection& section) {
  const std::string use = section.text("use");
  const auto kinds = effect_kinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto* k) { return k->name == use; });
  if (kind != kinds.end()) return *kind;
  std::vector<std::string> names;
  for (const auto* k : kinds) names.push_back(k->name);
  std::sort(names.begin(), names.end());
  section.refuse("use", en::say("there is no effect '{}'", printable(use)), one_of(names, use));
}

// Refuses two effects of a kind that may occur only once at a time.
void check_single(const YamlSection& section, const SceneEffect& named, const Scene& scene) {
  if (named.effect->is_repeatable()) return;
  const std::string& use = named.kind->name;
  for (const auto& other : scene.effects) {
    if (other.kind != named.kind || !named.presence.overlaps(other.presence)) continue;
    const int first = std::max(named.presence.first, other.presence.first);
    const int end = std::min(named.presence.end, other.presence.end);
    if (first == 0 && end == scene.time.frames)
      section.refuse("use", en::say("the effect '{}' is listed twice", use),
                     en::say("remove one of them"));
    section.refuse(
        "use", en::say("the effect '{}' is listed twice for frames {} to {}", use, first, end - 1),
        en::say("end one with 'until' before the other begins with 'from'"));
  }
}

// A separate stream from the second effect of a kind on; the first one draws as if it were alone.
std::uint64_t stream_of(const std::string& name, int number) {
  if (number == 1) return 0;
  const PhiloxCounter bits =
      philox({static_cast<std::uint32_t>(number), 0, 0, 0}, {fnv1a(name), fnv1a("number")});
  return std::uint64_t{bits[0]} << 32 | bits[1];
}

void read_effects(YamlSection& top, Scene& scene) {
  std::map<const EffectKind*, int> numbers;
  for (YamlSection& section : top.sections("effects")) {
    const EffectKind* kind = read_kind(section);
    const int number = ++numbers[kind];
    section.rename(number == 1 ? kind->name : fmt::format("{}#{}", kind->name, number));
    const SceneEffect named{kind,
                            section.name(),
                            Presence::read(section, scene.time),
                            stream_of(kind->name, number),
                            kind->make(section),
                            section.where("")};
    check_single(section, named, scene);
    if (named.effect->changes_lens()) {
      if (named.presence.first > 0 || named.presence.end < scene.time.frames)
        section.refuse("use", en::say("a lens does not change over time"),
                       en::say("leave 'from' and 'until' out"));
      named.effect->change_lens(scene.finger.camera);
      if (const auto made = Camera::create(scene.finger.camera); !made)
        section.refuse("", made.error().what, made.error().advice);
    }
    scene.effects.push_back(named);
  }
  std::stable_sort(scene.effects.begin(), scene.effects.end(), [](const auto& a, const auto& b) {
    return std::pair(a.kind->stage, a.kind->rank) < std::pair(b.kind->stage, b.kind->rank);
  });
}

std::string read_sentence(YamlSection& scene, const char* key) {
  std::string sentence = scene.text(key);
  if (sentence.empty())
    scene.refuse(key, en::say("this is not text"), en::say("a word or a sentence"));
  return sentence;
}

void read_scene(YamlSection& top, Scene& scene) {
  scene.name = read_sentence(top, "name");
  scene.why = read_sentence(top, "why");
  scene.time = SceneTime::of(top);
  YamlSection finger = top.section("finger");
  scene.finger.name = scene.name;
  scene.finger.camera = read_camera(finger.section("camera"));
  scene.finger.face = read_face(finger.section("face"));
  if (finger.has("markers")) scene.finger.markers = read_markers(finger.section("markers"));
  if (scene.finger.face.kind == FaceKind::kFinRay) read_untouched(top.section("untouched"), scene);
  if (top.has("motion")) {
    YamlSection motion = top.section("motion");
    scene.motion = Motion::read(motion);
  }
  read_effects(top, scene);
}

}  // namespace

Result<Scene> Scene::load(const std::filesystem::path& file) {
  auto text = read_file(file, kLargestScene);
  if (!text) return text.error();
  return parse(*text, file.string());
}

Result<Scene> Scene::parse(std::string_view yaml, const std::string& origin) {
  YamlFile file(origin, YamlFile::Unknown::kRefused);
  Scene scene;
  const Status read =
      file.read(std::string(yaml), [&](YamlSection& top) { read_scene(top, scene); });
  if (!read) return read.error();
  return scene;
}

}  // namespace alltact
