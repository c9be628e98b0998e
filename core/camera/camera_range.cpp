#include "core/camera/camera_range.h"

#include <algorithm>

namespace alltact {

Status check_camera_range(const CameraParameters& p) {
  if (const auto camera = Camera::create(p); !camera) return camera.error();
  const int side = std::max(p.width_px, p.height_px);
  if (p.model == CameraModel::kOrthographic) {
    constexpr double kLeastMm = 0.1, kMostMm = 10000;
    if (p.mm_per_px * side >= kLeastMm && p.mm_per_px * side <= kMostMm) return {};
    return Error{en::say("must be a number from {:g} to {:g}", kLeastMm / side, kMostMm / side),
                 std::string("camera.mm_per_px"),
                 en::say("millimetres on the object per pixel")};
  }
  constexpr double kWidest = 0.05, kNarrowest = 10, kSquare = 2;
  for (const auto& [value, other, key] :
       {std::tuple{p.fx_px, p.fy_px, "camera.fx"}, {p.fy_px, p.fx_px, "camera.fy"}}) {
    double least = kWidest * side, most = kNarrowest * side;
    // Where the other one is impossible itself, that is what must be said.
    if (other >= least && other <= most) {
      least = std::max(least, other / kSquare);
      most = std::min(most, other * kSquare);
    }
    if (!(value >= least && value <= most))
      return Error{en::say("must be a number from {:g} to {:g}", least, most),
                   std::string(key),
                   en::say("the focal length in pixels, as 'alltact lens' finds it")};
  }
  return {};
}

std::vector<Error> implausible_camera(const CameraParameters& p) {
  std::vector<Error> all;
  if (p.model == CameraModel::kOrthographic) return all;
  constexpr double kShortest = 0.2, kLongest = 4;  // of the longer side
  constexpr double kRim = 0.2;                     // of each side
  const double side = std::max(p.width_px, p.height_px);
  const auto look = [&all](const char* key, double value, double least, double most) {
    if (!(value >= least && value <= most))
      all.push_back(
          {en::say(
               "{:g} px is unusual ({:g} to {:g} px): check the decimal mark", value, least, most),
           std::string(key),
           ""});
  };
  look("camera.fx", p.fx_px, kShortest * side, kLongest * side);
  look("camera.fy", p.fy_px, kShortest * side, kLongest * side);
  look("camera.cx", p.cx_px, kRim * p.width_px, (1 - kRim) * p.width_px);
  look("camera.cy", p.cy_px, kRim * p.height_px, (1 - kRim) * p.height_px);
  return all;
}

}  // namespace alltact
