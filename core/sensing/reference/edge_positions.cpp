#include "core/sensing/reference/edge_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kColumnStep = 8;
constexpr double kNearlyAll = 0.95;     // of the faces
constexpr double kPositionSdPx = 0.05;  // of an edge's smooth curve

/// Linear interpolation between two samples, and extrapolation beyond the last ones.
double between(const std::vector<float>& x, const std::vector<float>& y, std::size_t k, double at) {
  const double x0 = x[k - 1], x1 = x[k], y0 = y[k - 1], y1 = y[k];
  return x1 == x0 ? y0 : y0 + (y1 - y0) * (at - x0) / (x1 - x0);
}

/// The first sample from 1 on whose column is at least u; the last one beyond.
std::size_t sample_after(const EdgeCurves& curves, double u) {
  const auto found = std::lower_bound(curves.u.begin(), curves.u.end(), u);
  const auto k = static_cast<std::size_t>(found - curves.u.begin());
  return std::clamp<std::size_t>(k, 1, curves.u.size() - 1);
}

double value_below(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * (values.size() - 1.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

EdgeCurves edge_curves(const FaceShape& shape) {
  EdgeCurves curves;
  curves.base_at_low_u = shape.base_at_low_u();
  for (int u = kColumnStep / 2; u < shape.width_px(); u += kColumnStep) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    curves.u.push_back(static_cast<float>(u));
    curves.upper.push_back(static_cast<float>(column.upper_v));
    curves.lower.push_back(static_cast<float>(column.lower_v));
    curves.along_mm.push_back(static_cast<float>(shape.length_at(u)));
  }
  return curves;
}

double along_mm_at(const EdgeCurves& curves, double u) {
  if (curves.u.size() < 2) return 0.0;
  return between(curves.u, curves.along_mm, sample_after(curves, u), u);
}

double middle_at(const EdgeCurves& curves, double u) {
  if (curves.u.size() < 2) return 0.0;
  const std::size_t k = sample_after(curves, u);
  return 0.5 * (between(curves.u, curves.upper, k, u) + between(curves.u, curves.lower, k, u));
}

double edge_distance_px(const EdgeCurves& a, const EdgeCurves& b) {
  double sum = 0;
  std::size_t shared = 0;
  for (std::size_t i = 0, k = 0; i < a.u.size(); ++i) {
    while (k < b.u.size() && b.u[k] < a.u[i]) ++k;
    if (k == b.u.size()) break;
    if (b.u[k] != a.u[i]) continue;
    sum += std::abs(static_cast<double>(a.upper[i] - b.upper[k])) +
           std::abs(static_cast<double>(a.lower[i] - b.lower[k]));
    ++shared;
  }
  if (shared == 0 || 2 * shared < std::max(a.u.size(), b.u.size()))
    return std::numeric_limits<double>::infinity();
  return sum / (2.0 * static_cast<double>(shared));
}

std::optional<EdgePositions> choose_edge_positions(const std::vector<EdgeCurves>& faces) {
  // In a few frames the nearer end may seem the farther one.
  const auto at_low_u = std::count_if(
      faces.begin(), faces.end(), [](const EdgeCurves& face) { return face.base_at_low_u; });
  const bool base_at_low_u = 2 * static_cast<std::size_t>(at_low_u) >= faces.size();
  const auto has_base = [&](const EdgeCurves& face) {
    return face.u.size() >= 2 && face.base_at_low_u == base_at_low_u;
  };
  std::vector<double> base_u, length_mm;
  for (const EdgeCurves& face : faces)
    if (has_base(face)) base_u.push_back(base_at_low_u ? face.u.front() : -face.u.back());
  if (base_u.empty()) return std::nullopt;
  EdgePositions positions;
  const double base = value_below(base_u, kNearlyAll);
  positions.from_u_px = base_at_low_u ? base : -base;
  for (const EdgeCurves& face : faces) {
    if (!has_base(face)) continue;
    const double tip_mm = std::max(face.along_mm.front(), face.along_mm.back());
    length_mm.push_back(tip_mm - along_mm_at(face, positions.from_u_px));
  }
  const double length = value_below(length_mm, 1.0 - kNearlyAll);
  if (!(length > 0)) return std::nullopt;
  // the first position lies half a step from the base
  positions.step_mm = length / EdgePositions::kPerEdge;
  return positions;
}

Markers markers_at(const EdgePositions& positions, const EdgeCurves& curves) {
  constexpr auto kPerEdge = static_cast<std::size_t>(EdgePositions::kPerEdge);
  Markers markers(2 * kPerEdge);
  if (curves.u.size() < 2) return markers;
  std::vector<float> along = curves.along_mm, u = curves.u;
  if (along.front() > along.back()) {
    std::reverse(along.begin(), along.end());
    std::reverse(u.begin(), u.end());
  }
  const double from_mm = along_mm_at(curves, positions.from_u_px);
  for (std::size_t i = 0; i < kPerEdge; ++i) {
    const double at_mm = from_mm + (static_cast<double>(i) + 0.5) * positions.step_mm;
    if (!(at_mm >= along.front() && at_mm <= along.back())) continue;
    const auto after = std::lower_bound(along.begin(), along.end(), static_cast<float>(at_mm));
    const auto k = std::clamp<std::size_t>(
        static_cast<std::size_t>(after - along.begin()), 1, along.size() - 1);
    const double column = between(along, u, k, at_mm);
    const std::size_t sample = sample_after(curves, column);
    markers[i] = {column, between(curves.u, curves.upper, sample, column), true, kPositionSdPx};
    markers[kPerEdge + i] = {
        column, between(curves.u, curves.lower, sample, column), true, kPositionSdPx};
  }
  return markers;
}

}  // namespace alltact
