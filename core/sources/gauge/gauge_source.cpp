#include "core/sources/gauge/gauge_source.h"

#include "core/printable.h"

#include <chrono>
#include <cmath>

namespace alltact {

double gauge_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::optional<Eigen::Vector3d> axis_named(std::string_view name) {
  const double sign = name.starts_with('-') ? -1 : 1;
  if (name.starts_with('-') || name.starts_with('+')) name.remove_prefix(1);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (name == std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1))
      return Eigen::Vector3d(sign * Eigen::Vector3d::Unit(axis));
  return std::nullopt;
}

Result<GaugeDirections> GaugeDirections::parse(const std::string& text) {
  const Error wrong{en::say("'{}' is no direction", printable(text)),
                    "",
                    en::say("x, -y, 0.6,0.8,0 or, for several values, x/y/z")};
  GaugeDirections directions;
  std::string_view rest = text;
  while (true) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string_view part = rest.substr(0, end);
    auto direction = axis_named(part);
    if (!direction) {
      const GaugeLine line = read_gauge_line(part, {});
      if (line.kind != GaugeLine::Kind::kValues || line.count != 3) return wrong;
      direction = Eigen::Vector3d(line.force_N[0], line.force_N[1], line.force_N[2]);
    }
    if (!(direction->norm() > 1e-9) || directions.count == 3) return wrong;
    directions.of[static_cast<std::size_t>(directions.count++)] = direction->normalized();
    if (end == rest.size()) return directions;
    rest.remove_prefix(end + 1);
  }
}

Eigen::Vector3d GaugeDirections::force_N(const GaugeLine& line) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(line.count); ++i)
    force += line.force_N[i] * of[i];
  return force;
}

GaugeSample sample_of(const GaugeLine& line, const GaugeDirections& directions, double time_s) {
  GaugeSample sample;
  sample.time_s = time_s;
  sample.has_force = true;
  sample.force_N = directions.force_N(line);
  double coarsest_N = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(line.count); ++i)
    coarsest_N = std::max(coarsest_N, line.digit_N[i]);
  if (coarsest_N > 0) sample.sd_N = coarsest_N / std::sqrt(12.0);
  return sample;
}

}  // namespace alltact
