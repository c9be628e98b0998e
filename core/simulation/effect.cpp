#include "core/simulation/effect.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <cmath>

namespace alltact {

BuildCount& build_count() {
  static BuildCount count;
  return count;
}

Status check_position(const SceneFacts& scene, const Varying& s_mm, const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (face.kind == FaceKind::kFlat) return {};
  if (s_mm.min_value() < 0 || s_mm.max_value() > scene.length_mm)
    return Error{en::say("s_mm is beyond the ends of the face"), "",
                 en::say("0 to {:g}", scene.length_mm)};
  if (y_mm.min_value() < -face.width_mm / 2 || y_mm.max_value() > face.width_mm / 2)
    return Error{en::say("y_mm is outside the face"), "",
                 en::say("{:g} to {:g}", -face.width_mm / 2, face.width_mm / 2)};
  return {};
}

Status check_press(const SceneFacts& scene, const Varying& depth_mm, const Varying& s_mm,
                   const Varying& y_mm) {
  const Face& face = scene.finger.face;
  if (depth_mm.max_value() >= face.layer_mm)
    return Error{en::say("depth_mm = {:g} reaches through the layer of {:g} mm",
                         depth_mm.max_value(), face.layer_mm),
                 "", en::say("less than finger.face.layer_mm")};
  return check_position(scene, s_mm, y_mm);
}

namespace {

ALLTACT_WIDE void add_level(int n, float level, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += level;
}

}  // namespace

void add_to_row(const RowView& row, float level) { add_level(row.width, level, row.value); }

void mark_row(const Camera& camera, const FaceMark& mark, double factor, double level,
              RowView& row) {
  const FaceRow& face = row.face;
  const Eigen::Vector2d segment = mark.to_mm - mark.from_mm;
  const double length2 = segment.squaredNorm();
  const double s_low = std::min(mark.from_mm.x(), mark.to_mm.x()) - mark.radius_mm - 1;
  const double s_high = std::max(mark.from_mm.x(), mark.to_mm.x()) + mark.radius_mm + 1;
  for (int u = face.first; u < face.last; ++u) {
    if (face.s_mm[u] < s_low || face.s_mm[u] > s_high) continue;
    const Eigen::Vector2d at(face.s_mm[u], face.y_mm[u] - face.shift_mm[u]);
    const double along =
        length2 > 0 ? std::clamp((at - mark.from_mm).dot(segment) / length2, 0.0, 1.0) : 0.0;
    const double inside = mark.radius_mm - (at - mark.from_mm - along * segment).norm();
    const double part = std::clamp(inside / camera.mm_per_px_at(face.z_mm[u]) + 0.5, 0.0, 1.0);
    if (part == 0) continue;
    float& light = row.surfaces[0].light[u];
    light = static_cast<float>(light * (1 + (factor - 1) * part) + level * part);
  }
}

namespace {

constexpr std::size_t kMaxMarkers = 128;

}  // namespace

std::vector<std::size_t> read_marker_numbers(YamlSection& section) {
  std::vector<std::size_t> numbers;
  for (const double given : section.numbers("markers", 1, kMaxMarkers, {-1e6, 1e6})) {
    if (given < 0 || given != std::floor(given))
      section.refuse("markers", en::say("{:g} is not a marker number", given),
                     en::say("0, 1, 2, ..."));
    const auto number = static_cast<std::size_t>(given);
    if (std::find(numbers.begin(), numbers.end(), number) != numbers.end())
      section.refuse("markers", en::say("marker {} is listed twice", number),
                     en::say("each number once"));
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace alltact
