#include "core/sensing/arc_parameter.h"

#include <algorithm>
#include <cmath>

namespace alltact {

ArcParameter::ArcParameter(const std::vector<double>& width_px, double first, double last)
    : t_(width_px.size()), slope_(width_px.size()) {
  const auto columns = static_cast<double>(width_px.size());
  const auto begin = static_cast<std::size_t>(std::clamp(std::floor(first), 0.0, columns - 1.0));
  const auto end = static_cast<std::size_t>(std::clamp(std::ceil(last), 0.0, columns - 1.0));
  for (std::size_t u = 0; u < width_px.size(); ++u) {
    const double width = width_px[std::clamp(u, begin, end)];
    slope_[u] = 1.0 / (width * std::sqrt(width));
    if (u > 0) t_[u] = t_[u - 1] + 0.5 * (slope_[u - 1] + slope_[u]);
  }
  const double low = at(first), scale = 2.0 / (at(last) - low);
  for (std::size_t u = 0; u < width_px.size(); ++u) {
    t_[u] = scale * (t_[u] - low) - 1.0;
    slope_[u] *= scale;
  }
}

std::size_t ArcParameter::cell_of(double u) const {
  return static_cast<std::size_t>(std::clamp(u, 0.0, static_cast<double>(t_.size()) - 2.0));
}

// Within a cell the slope is a line and t its integral.
double ArcParameter::at(double u) const {
  if (t_.size() < 2) return u;
  if (u < 0.0) return t_.front() + u * slope_.front();
  const double beyond = u - static_cast<double>(t_.size() - 1);
  if (beyond > 0.0) return t_.back() + beyond * slope_.back();
  const std::size_t i = cell_of(u);
  const double part = u - static_cast<double>(i);
  return t_[i] + part * (slope_[i] + 0.5 * part * (slope_[i + 1] - slope_[i]));
}

double ArcParameter::slope_at(double u) const {
  if (t_.size() < 2) return 1.0;
  const double inside = std::clamp(u, 0.0, static_cast<double>(t_.size() - 1));
  const std::size_t i = cell_of(inside);
  return slope_[i] + (inside - static_cast<double>(i)) * (slope_[i + 1] - slope_[i]);
}

}  // namespace alltact
