#include "calibration/experiments/finger_variant.h"

#include "core/numerics/philox.h"
#include "core/yaml/yaml_file.h"
#include "core/yaml/yaml_writer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace alltact {
namespace {

constexpr double kFullWidth_px = 960, kFullHeight_px = 540;

YamlValue number_value(double value) {
  YamlValue made;
  made.kind = YamlValue::Kind::kScalar;
  made.text = yaml_number(value);
  return made;
}

YamlValue* entry_of(YamlValue& map, std::string_view key) {
  for (auto& [name, value] : map.entries)
    if (name == key) return &value;
  return nullptr;
}

/// Sets the value where the map has the key.
void put(YamlValue& map, std::string_view key, double value) {
  if (YamlValue* entry = entry_of(map, key)) *entry = number_value(value);
}

void put_integer(YamlValue& map, std::string_view key, int value) {
  if (YamlValue* entry = entry_of(map, key)) entry->text = std::to_string(value);
}

void put_camera(YamlValue& camera, const FingerVariant& f) {
  if (YamlValue* size = entry_of(camera, "size"); size != nullptr && size->items.size() == 2) {
    size->items[0].text = std::to_string(std::lround(kFullWidth_px * f.scale));
    size->items[1].text = std::to_string(std::lround(kFullHeight_px * f.scale));
  }
  put(camera, "fx", f.focal_px * f.scale);
  put(camera, "fy", f.focal_px * f.scale);
  // The middle of the first pixel lies at 0.
  put(camera, "cx", (f.cx_px + 0.5) * f.scale - 0.5);
  put(camera, "cy", (f.cy_px + 0.5) * f.scale - 0.5);
}

void put_finger(YamlValue& finger, const FingerVariant& f) {
  if (YamlValue* camera = entry_of(finger, "camera")) put_camera(*camera, f);
  if (YamlValue* face = entry_of(finger, "face")) {
    put(*face, "width_mm", f.width_mm);
    put(*face, "layer_mm", f.layer_mm);
  }
  if (YamlValue* markers = entry_of(finger, "markers")) put_integer(*markers, "per_row", f.per_row);
}

void put_pose(YamlValue& untouched, const FingerVariant& f) {
  put(untouched, "x_mm", f.x_mm);
  put(untouched, "z_mm", f.z_mm);
  put(untouched, "incline_deg", f.incline_deg);
  put(untouched, "length_mm", f.length_mm);
}

void put_lamps(YamlValue& leds, const FingerVariant& f) {
  YamlValue* lamps = entry_of(leds, "lamps");
  if (lamps == nullptr) return;
  for (YamlValue& lamp : lamps->items)
    if (YamlValue* power = entry_of(lamp, "power"))
      *power = number_value(f.light * std::strtod(power->text.c_str(), nullptr));
}

void put_effect(YamlValue& effect, const FingerVariant& f) {
  const YamlValue* use = entry_of(effect, "use");
  if (use == nullptr) return;
  if (use->text == "markers") {
    put(effect, "radius_mm", f.dot_radius_mm);
    put(effect, "setback_mm", f.setback_mm);
    put(effect, "first", f.first);
    put(effect, "last", f.last);
    put(effect, "albedo", f.dot_albedo);
  } else if (use->text == "layer") {
    put(effect, "scatter_per_mm", f.scatter_per_mm);
  } else if (use->text == "sides") {
    put(effect, "albedo", f.side_albedo);
  } else if (use->text == "leds") {
    put_lamps(effect, f);
  } else if (use->text == "body") {
    put(effect, "shore_a", f.shore_a);
    put(effect, "wall_mm", f.wall_mm);
    put(effect, "base_depth_mm", f.base_depth_mm);
    put(effect, "tip_depth_mm", f.tip_depth_mm);
    put(effect, "coupling", f.coupling);
  } else if (use->text == "push") {
    put(effect, "layer_shore_a", f.layer_shore_a);
  } else if (use->text == "ambient" && f.room_level) {
    put(effect, "level", *f.room_level);
  }
}

}  // namespace

FingerVariant FingerVariant::draw(std::uint64_t seed, int number) {
  std::uint32_t drawn = 0;
  const auto between = [&](double low, double high) {
    return low +
           (high - low) *
               philox_uniform(seed, "drawn finger", static_cast<std::uint32_t>(number), drawn++);
  };
  FingerVariant finger;
  finger.width_mm = between(20, 27);
  finger.layer_mm = between(1.3, 1.7);
  finger.x_mm = between(-24.5, -21);
  finger.z_mm = between(28, 32);
  finger.incline_deg = between(31, 37);
  finger.length_mm = between(112, 124);
  finger.focal_px = between(480, 530);
  finger.cx_px = between(472, 488);
  finger.cy_px = between(260, 280);
  finger.per_row = static_cast<int>(between(5, 10));
  finger.dot_radius_mm = between(1.1, 1.6);
  finger.setback_mm = between(3.5, 5);
  finger.first = between(0.08, 0.14);
  finger.last = between(0.84, 0.92);
  finger.dot_albedo = between(0.75, 0.95);
  finger.scatter_per_mm = between(0.5, 0.7);
  finger.side_albedo = between(0.08, 0.15);
  finger.light = between(0.8, 1.1);
  finger.shore_a = between(32, 50);
  finger.wall_mm = between(3.5, 4.5);
  finger.base_depth_mm = between(31, 37);
  finger.tip_depth_mm = between(11, 14);
  finger.coupling = between(0.3, 0.7);
  finger.layer_shore_a = between(4, 8);
  return finger;
}

Result<std::string> scene_text_on_finger(std::string_view yaml,
                                         const std::filesystem::path& origin,
                                         const FingerVariant& finger) {
  YamlFile file(origin, YamlFile::Unknown::kRetained);
  const Status read = file.read(std::string(yaml), [](YamlSection&) {});
  if (!read) return read.error();
  for (auto& [key, value] : file.unknown()[""]) {
    if (key == "finger") put_finger(value, finger);
    if (key == "untouched") put_pose(value, finger);
    if (key == "effects")
      for (YamlValue& effect : value.items) put_effect(effect, finger);
  }
  YamlBlock scene("");
  scene.add_unknown(file.unknown());
  return scene.on_many_lines();
}

Result<Scene> scene_on_finger(std::string_view yaml,
                              const std::filesystem::path& origin,
                              const FingerVariant& finger) {
  const auto text = scene_text_on_finger(yaml, origin, finger);
  if (!text) return text.error();
  return Scene::parse(*text, origin.string());
}

}  // namespace alltact
