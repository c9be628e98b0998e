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

/// Numbers of the seen markers; all, when none is seen.
std::vector<std::size_t> counted_markers(const Markers& markers) {
  std::vector<std::size_t> numbers;
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (markers[m].seen) numbers.push_back(m);
  if (numbers.empty())
    for (std::size_t m = 0; m < markers.size(); ++m) numbers.push_back(m);
  return numbers;
}

}  // namespace

LayoutSearch::LayoutSearch(const Eigen::MatrixXd& layouts)
    : frames_(static_cast<std::size_t>(layouts.rows())),
      markers_(static_cast<std::size_t>(layouts.cols()) / 2) {
  group_layouts(layouts, static_cast<std::size_t>(std::ceil(std::sqrt(frames_))));
  const std::size_t columns = 2 * markers_;
  coordinates_.resize(frames_ * columns);
  index_of_row_.resize(frames_);
  for (Group& group : groups_) {
    const std::size_t size = group.end - group.begin;
    group.reach_px.assign(markers_, 0.0F);
    for (std::size_t i = 0; i < size; ++i) {
      const int row = rows_[group.begin + i];
      index_of_row_[static_cast<std::size_t>(row)] = group.begin + i;
      float* at = coordinates_.data() + group.begin * columns + i;
      for (std::size_t c = 0; c < columns; ++c)
        at[c * size] = static_cast<float>(layouts(row, static_cast<Eigen::Index>(c)));
      for (std::size_t m = 0; m < markers_; ++m)
        group.reach_px[m] = std::max(group.reach_px[m],
                                     std::hypot(at[2 * m * size] - group.centre[2 * m],
                                                at[(2 * m + 1) * size] - group.centre[2 * m + 1]));
    }
  }
}

/// Chooses centres evenly over the recording; each layout goes to the nearest.
void LayoutSearch::group_layouts(const Eigen::MatrixXd& layouts, std::size_t count) {
  std::vector<std::vector<float>> columns(2 * markers_, std::vector<float>(count));
  for (std::size_t g = 0; g < count; ++g)
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c][g] = static_cast<float>(
          layouts(static_cast<Eigen::Index>(g * frames_ / count), static_cast<Eigen::Index>(c)));
  std::vector<std::vector<int>> members(count);
  std::vector<float> sum(count);
  for (std::size_t row = 0; row < frames_; ++row) {
    std::fill(sum.begin(), sum.end(), 0.0F);
    for (std::size_t m = 0; m < markers_; ++m)
      add_distances(columns[2 * m].data(),
                    columns[2 * m + 1].data(),
                    static_cast<float>(
                        layouts(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(2 * m))),
                    static_cast<float>(layouts(static_cast<Eigen::Index>(row),
                                               static_cast<Eigen::Index>(2 * m + 1))),
                    count,
                    sum.data());
    const auto nearest_group = std::min_element(sum.begin(), sum.end()) - sum.begin();
    members[static_cast<std::size_t>(nearest_group)].push_back(static_cast<int>(row));
  }
  for (std::size_t g = 0; g < count; ++g) {
    if (members[g].empty()) continue;  // duplicate of another centre
    Group group{rows_.size(), rows_.size() + members[g].size(), {}, {}};
    for (const auto& column : columns) group.centre.push_back(column[g]);
    rows_.insert(rows_.end(), members[g].begin(), members[g].end());
    groups_.push_back(std::move(group));
  }
}

std::vector<LayoutSearch::Bound> LayoutSearch::bounds(const Markers& markers) const {
  const std::vector<std::size_t> numbers = counted_markers(markers);
  // Bounds on the rounding errors of sums of floats and of the stored coordinates.
  constexpr float kRoundingFactor = 1 - 1e-4F, kRoundingPx = 1e-2F;
  std::vector<Bound> bounds(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    float sum = 0;
    for (const std::size_t m : numbers) {
      const float du = static_cast<float>(markers[m].u) - group.centre[2 * m];
      const float dv = static_cast<float>(markers[m].v) - group.centre[2 * m + 1];
      sum += std::max(0.0F, std::sqrt(du * du + dv * dv) - group.reach_px[m]);
    }
    bounds[g] = {kRoundingFactor * sum - kRoundingPx, g};
  }
  std::sort(bounds.begin(), bounds.end(), [](const Bound& a, const Bound& b) {
    return a.lower_bound < b.lower_bound;
  });
  return bounds;
}

LayoutSearch::Found LayoutSearch::nearest(const Markers& markers,
                                          const std::vector<char>& without) const {
  const std::vector<std::size_t> numbers = counted_markers(markers);
  std::vector<float> sum;
  int best_row = 0;
  float best = std::numeric_limits<float>::infinity();
  for (const Bound& bound : bounds(markers)) {
    if (bound.lower_bound > best) break;
    const Group& group = groups_[bound.group];
    const std::size_t size = group.end - group.begin;
    sum.assign(size, 0.0F);
    for (const std::size_t m : numbers) {
      const float* u = coordinates_.data() + group.begin * 2 * markers_ + 2 * m * size;
      add_distances(u,
                    u + size,
                    static_cast<float>(markers[m].u),
                    static_cast<float>(markers[m].v),
                    size,
                    sum.data());
    }
    for (std::size_t i = 0; i < size; ++i) {
      const int row = rows_[group.begin + i];
      if (sum[i] > best || (sum[i] == best && row >= best_row)) continue;
      if (!without.empty() && without[static_cast<std::size_t>(row)] != 0) continue;
      best = sum[i];
      best_row = row;
    }
  }
  return {
      best_row,
      static_cast<double>(best) / static_cast<double>(std::max<std::size_t>(1, numbers.size()))};
}

LayoutSearch::Stored LayoutSearch::stored(std::size_t row) const {
  const std::size_t index = index_of_row_[row];
  const auto group =
      std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return index < g.end; });
  return {coordinates_.data() + group->begin * 2 * markers_ + (index - group->begin),
          group->end - group->begin};
}

double LayoutSearch::distance_px(const Markers& markers,
                                 const std::vector<int>& rows,
                                 const Eigen::VectorXd& weights) const {
  const auto seen = [](const Marker& m) { return m.seen; };
  const bool any_seen = std::any_of(markers.begin(), markers.end(), seen);
  std::vector<Stored> layouts;
  for (const int row : rows) layouts.push_back(stored(static_cast<std::size_t>(row)));
  double sum = 0;
  int used = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (any_seen && !markers[m].seen) continue;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < layouts.size(); ++i)
      position +=
          weights[static_cast<Eigen::Index>(i)] * Eigen::Vector2d(layouts[i].u(m), layouts[i].v(m));
    sum += std::hypot(markers[m].u - position.x(), markers[m].v - position.y());
    ++used;
  }
  return sum / std::max(1, used);
}

double LayoutSearch::median_step_px() const {
  std::vector<double> steps;
  std::vector<char> without(frames_, 0);
  const std::size_t every = std::max<std::size_t>(1, frames_ / 200);
  for (std::size_t row = 0; row < frames_; row += every) {
    const Stored at = stored(row);
    Markers markers(markers_);
    for (std::size_t m = 0; m < markers_; ++m) markers[m] = {at.u(m), at.v(m), true, 0};
    without[row] = 1;
    steps.push_back(nearest(markers, without).distance_px);
    without[row] = 0;
  }
  return upper_median(steps);
}

std::size_t LayoutSearch::memory_bytes() const {
  return coordinates_.size() * sizeof(float) + rows_.size() * sizeof(int) +
         index_of_row_.size() * sizeof(std::size_t) +
         groups_.size() * (sizeof(Group) + 3 * markers_ * sizeof(float));
}

double known_distance_px(const LayoutSearch& search) {
  constexpr double kSteps = 3.0;    // times the recording's own median step
  constexpr double kFloorPx = 1.5;  // a recording does not resolve poses more finely
  return std::max(kFloorPx, kSteps * search.median_step_px());
}

}  // namespace alltact
