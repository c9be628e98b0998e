#include "core/camera/camera_range.h"

#include <algorithm>

namespace alltact {

Status check_camera_range(const CameraParameters& p) {
  if (const auto camera = Camera::create(p); !camera) return camera.error();
  const int side = std::max(p.width_px, p.height_px);
  if (p.model == CameraModel::kOrthographic) {
    constexpr double kMinMm = 0.1, kMaxMm = 10000;
    if (p.mm_per_px * side >= kMinMm && p.mm_per_px * side <= kMaxMm) return {};
    return Error{en::say("must be a number from {:g} to {:g}", kMinMm / side, kMaxMm / side),
                 std::string("camera.mm_per_px"),
                 en::say("millimetres on the object per pixel")};
  }
  constexpr double kWidest = 0.05, kNarrowest = 10, kSquare = 2;
  for (const auto& [value, other, key] :
       {std::tuple{p.fx_px, p.fy_px, "camera.fx"}, {p.fy_px, p.fx_px, "camera.fy"}}) {
    double low = kWidest * side, high = kNarrowest * side;
    // Where the other focal length is impossible itself, only that one is reported.
    if (other >= low && other <= high) {
      low = std::max(low, other / kSquare);
      high = std::min(high, other * kSquare);
    }
    if (!(value >= low && value <= high))
      return Error{en::say("must be a number from {:g} to {:g}", low, high),
                   std::string(key),
                   en::say("the focal length in pixels, as 'alltact lens' finds it")};
  }
  return {};
}

std::vector<Error> implausible_camera(const CameraParameters& p) {
  std::vector<Error> all;
  if (p.model == CameraModel::kOrthographic) return all;
  constexpr double kShortest = 0.2, kLongest = 4;  // relative to the longer side
  constexpr double kRim = 0.2;                     // relative to each side
  const double side = std::max(p.width_px, p.height_px);
  const auto check = [&all](const char* key, double value, double low, double high) {
    if (!(value >= low && value <= high))
      all.push_back(
          {en::say(
               "{:g} px is unusual ({:g} to {:g} px): check the decimal mark", value, low, high),
           std::string(key),
           ""});
  };
  check("camera.fx", p.fx_px, kShortest * side, kLongest * side);
  check("camera.fy", p.fy_px, kShortest * side, kLongest * side);
  check("camera.cx", p.cx_px, kRim * p.width_px, (1 - kRim) * p.width_px);
  check("camera.cy", p.cy_px, kRim * p.height_px, (1 - kRim) * p.height_px);
  return all;
}

}  // namespace alltact
