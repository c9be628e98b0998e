#include "core/camera/flat_port.h"

namespace alltact {
namespace {

/// With a = tan of the angle in air, its tangent in a medium of index n >= 1, where sin = a /
/// sqrt(1 + a^2) is n times smaller. Written without a difference that cancels.
double tangent_in(double index, double a) {
  return a / std::sqrt(index * index + (index - 1) * (index + 1) * a * a);
}

/// Derivative of tangent_in() by a.
double tangent_slope_in(double index, double a) {
  const double root = std::sqrt(index * index + (index - 1) * (index + 1) * a * a);
  return index * index / (root * root * root);
}

constexpr double kSteepest = 1000;  // tangent of 89.9 degrees

}  // namespace

Status check_port(const FlatPort& port) {
  for (const auto& [value, key] : {std::pair{port.gap_mm, "gap_mm"}, {port.plate_mm, "plate_mm"}})
    if (!(value >= 0 && value <= 1000))
      return Error{en::say("must be a length from 0 to 1000 mm"),
                   std::string(key),
                   en::say("a caliper's reading")};
  for (const auto& [value, key] :
       {std::pair{port.plate_index, "plate_index"}, {port.medium_index, "medium_index"}})
    if (!(value >= 1 && value <= 3))
      return Error{en::say("must be an index of refraction from 1 to 3"),
                   std::string(key),
                   en::say("1 for air, 1.33 water, 1.41 silicone, 1.49 acrylic, 1.52 glass")};
  return {};
}

std::optional<Ray> ray_through(const FlatPort& port, const Eigen::Vector3d& air_direction) {
  if (!(air_direction.z() > 0)) return std::nullopt;
  const Eigen::Vector2d aside = air_direction.head<2>() / air_direction.z();
  const double a = aside.norm();
  if (!(a <= kSteepest)) return std::nullopt;
  Ray ray;
  if (a == 0) return ray;
  const Eigen::Vector2d outward = aside / a;
  const double slope = tangent_in(port.medium_index, a);
  const double leaves = port.gap_mm * a + port.plate_mm * tangent_in(port.plate_index, a);
  ray.origin_mm.head<2>() = outward * (leaves - slope * (port.gap_mm + port.plate_mm));
  ray.direction.head<2>() = outward * slope;
  return ray;
}

std::optional<Eigen::Vector3d> direction_to(const FlatPort& port, const Eigen::Vector3d& point_mm) {
  const double in_medium = point_mm.z() - port.gap_mm - port.plate_mm;
  if (!(in_medium > 0)) return std::nullopt;
  const double radius = point_mm.head<2>().norm();
  if (radius == 0) return Eigen::Vector3d::UnitZ();
  // The radius reached grows with a and its slope falls: from the left Newton never oversteps.
  const auto reached = [&](double a) {
    return port.gap_mm * a + port.plate_mm * tangent_in(port.plate_index, a) +
           in_medium * tangent_in(port.medium_index, a);
  };
  if (!(reached(kSteepest) >= radius)) return std::nullopt;
  double low = 0, high = kSteepest, a = 0;
  constexpr int kSteps = 200;
  for (int step = 0; step < kSteps; ++step) {
    const double missing = radius - reached(a);
    (missing >= 0 ? low : high) = a;
    if (missing == 0) break;
    const double slope = port.gap_mm + port.plate_mm * tangent_slope_in(port.plate_index, a) +
                         in_medium * tangent_slope_in(port.medium_index, a);
    double next = a + missing / slope;
    if (!(next >= low && next <= high)) next = low + (high - low) / 2;
    if (std::abs(next - a) <= 1e-16 * a) break;
    a = next;
  }
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  direction.head<2>() = point_mm.head<2>() * (a / radius);
  return direction;
}

double apparent_distance_mm(const FlatPort& port, double z_mm) {
  return port.gap_mm + port.plate_mm / port.plate_index +
         (z_mm - port.gap_mm - port.plate_mm) / port.medium_index;
}

}  // namespace alltact
