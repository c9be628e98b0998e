#include "core/sensing/markers/layout_search.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

ALLTACT_WIDE void add_distances(
    const float* u, const float* v, float at_u, float at_v, std::size_t n, float* sum) {
  for (std::size_t i = 0; i < n; ++i) {
    const float du = u[i] - at_u, dv = v[i] - at_v;
    sum[i] += std::sqrt(du * du + dv * dv);
  }
}

}  // namespace

LayoutSearch::LayoutSearch(const Eigen::MatrixXd& layouts)
    : frames_(static_cast<std::size_t>(layouts.rows())),
      places_(layouts.data(), layouts.data() + layouts.size()) {}  // column by column already

LayoutSearch::Found LayoutSearch::nearest(const Markers& markers,
                                          const std::vector<char>& without) const {
  std::vector<float> sum(frames_, 0.0F);
  const auto seen = [](const Marker& m) { return m.seen; };
  const bool any_seen = std::any_of(markers.begin(), markers.end(), seen);
  int used = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (any_seen && !markers[m].seen) continue;
    const float* u = places_.data() + 2 * m * frames_;
    add_distances(u,
                  u + frames_,
                  static_cast<float>(markers[m].u),
                  static_cast<float>(markers[m].v),
                  frames_,
                  sum.data());
    ++used;
  }
  for (std::size_t i = 0; i < without.size(); ++i)
    if (without[i] != 0) sum[i] = std::numeric_limits<float>::infinity();
  const auto least = std::min_element(sum.begin(), sum.end());
  return {static_cast<int>(least - sum.begin()), static_cast<double>(*least) / std::max(1, used)};
}

double LayoutSearch::distance_px(const Markers& markers,
                                 const std::vector<int>& rows,
                                 const Eigen::VectorXd& weights) const {
  const auto seen = [](const Marker& m) { return m.seen; };
  const bool any_seen = std::any_of(markers.begin(), markers.end(), seen);
  double sum = 0;
  int used = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (any_seen && !markers[m].seen) continue;
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const float* u = places_.data() + 2 * m * frames_ + static_cast<std::size_t>(rows[i]);
      place += weights[static_cast<Eigen::Index>(i)] *
               Eigen::Vector2d(static_cast<double>(u[0]), static_cast<double>(u[frames_]));
    }
    sum += std::hypot(markers[m].u - place.x(), markers[m].v - place.y());
    ++used;
  }
  return sum / std::max(1, used);
}

double LayoutSearch::median_step_px() const {
  std::vector<double> steps;
  std::vector<char> without(frames_, 0);
  const std::size_t markers_count = places_.size() / (2 * frames_);
  const std::size_t every = std::max<std::size_t>(1, frames_ / 200);
  for (std::size_t i = 0; i < frames_; i += every) {
    Markers markers(markers_count);
    for (std::size_t m = 0; m < markers_count; ++m)
      markers[m] = {places_[2 * m * frames_ + i], places_[(2 * m + 1) * frames_ + i], true, 0};
    without[i] = 1;
    steps.push_back(nearest(markers, without).distance_px);
    without[i] = 0;
  }
  return upper_median(steps);
}

double known_distance_px(const LayoutSearch& search) {
  constexpr double kSteps = 3.0;    // of the recording's own median step
  constexpr double kFloorPx = 1.5;  // a recording cannot be told apart more finely than this
  return std::max(kFloorPx, kSteps * search.median_step_px());
}

}  // namespace alltact
