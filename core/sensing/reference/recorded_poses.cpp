#include "core/sensing/reference/recorded_poses.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"
#include "core/sensing/markers/marker_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {
namespace {

ALLTACT_WIDE void add_distances(const float* u, const float* v, float at_u, float at_v,
                                std::size_t n, float* sum) {
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
      add_distances(columns[2 * m].data(), columns[2 * m + 1].data(),
                    static_cast<float>(
                        layouts(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(2 * m))),
                    static_cast<float>(layouts(static_cast<Eigen::Index>(row),
                                               static_cast<Eigen::Index>(2 * m + 1))),
                    count, sum.data());
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
  std::sort(bounds.begin(), bounds.end(),
            [](const Bound& a, const Bound& b) { return a.lower_bound < b.lower_bound; });
  return bounds;
}

NearestFrame LayoutSearch::nearest(const Markers& markers, const std::vector<char>& without) const {
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
      add_distances(u, u + size, static_cast<float>(markers[m].u), static_cast<float>(markers[m].v),
                    size, sum.data());
    }
    for (std::size_t i = 0; i < size; ++i) {
      const int row = rows_[group.begin + i];
      if (sum[i] > best || (sum[i] == best && row >= best_row)) continue;
      if (!without.empty() && without[static_cast<std::size_t>(row)] != 0) continue;
      best = sum[i];
      best_row = row;
    }
  }
  return {best_row, static_cast<double>(best) /
                        static_cast<double>(std::max<std::size_t>(1, numbers.size()))};
}

LayoutSearch::Stored LayoutSearch::stored(std::size_t row) const {
  const std::size_t index = index_of_row_[row];
  const auto group =
      std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return index < g.end; });
  return {coordinates_.data() + group->begin * 2 * markers_ + (index - group->begin),
          group->end - group->begin};
}

double LayoutSearch::distance_px(const Markers& markers, const std::vector<int>& rows,
                                 const Eigen::VectorXd& weights) const {
  std::vector<Stored> layouts;
  for (const int row : rows) layouts.push_back(stored(static_cast<std::size_t>(row)));
  const std::vector<std::size_t> numbers = counted_markers(markers);
  double sum = 0;
  for (const std::size_t m : numbers) {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < layouts.size(); ++i)
      position +=
          weights[static_cast<Eigen::Index>(i)] * Eigen::Vector2d(layouts[i].u(m), layouts[i].v(m));
    sum += std::hypot(markers[m].u - position.x(), markers[m].v - position.y());
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, numbers.size()));
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

namespace {

// With k the diagonal of the kernel and D the offsets p_i - query, the minimum is
//   w = k (lambda - D mu),  mu = (ridge^2 I + D' k D)^-1 D' k lambda,  lambda so that sum w = 1.
Eigen::VectorXd weights_with(const Eigen::MatrixXd& offsets, const Eigen::VectorXd& kernel,
                             double ridge_px) {
  const Eigen::MatrixXd weighted = kernel.asDiagonal() * offsets;
  Eigen::MatrixXd normal = offsets.transpose() * weighted;
  normal.diagonal().array() += ridge_px * ridge_px;
  const Eigen::VectorXd mean = weighted.colwise().sum().transpose();
  const Eigen::VectorXd w = kernel - weighted * normal.ldlt().solve(mean);
  return w / w.sum();
}

/// Selects rows by their distance from the pose: the nearest half, and further ones in new
/// directions. A row is redundant if it lies nearer to a selected row than half of its distance to
/// the pose.
std::vector<int> spread_neighbours(const Eigen::MatrixXd& modes, const Eigen::VectorXd& pose,
                                   const std::vector<int>& nearest, int count) {
  constexpr double kApart = 0.5;
  const auto max_rows = static_cast<std::size_t>(count);
  std::vector<int> taken, passed;
  for (const int row : nearest) {
    if (taken.size() == max_rows) break;
    const double min_px = kApart * (modes.row(row) - pose.transpose()).norm();
    const bool is_another = taken.size() < (max_rows + 1) / 2 ||
                            std::all_of(taken.begin(), taken.end(), [&](int other) {
                              return (modes.row(row) - modes.row(other)).norm() >= min_px;
                            });
    (is_another ? taken : passed).push_back(row);
  }
  for (std::size_t i = 0; taken.size() < max_rows && i < passed.size(); ++i)
    taken.push_back(passed[i]);
  return taken;
}

double reach_px2(const Eigen::MatrixXd& points, const Eigen::VectorXd& pose,
                 const Eigen::VectorXd& weights) {
  const Eigen::VectorXd square = (points.rowwise() - pose.transpose()).rowwise().squaredNorm();
  const double missed = (points.transpose() * weights - pose).norm();
  const double magnitude = weights.lpNorm<1>();
  const double spread = weights.cwiseAbs().dot(square);
  return spread + missed * std::sqrt(spread / std::max(1.0, magnitude));
}

}  // namespace

Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points, const Eigen::VectorXd& query,
                                     double ridge_px, double max_magnitude) {
  const Eigen::MatrixXd offsets = points.rowwise() - query.transpose();
  const Eigen::VectorXd square = offsets.rowwise().squaredNorm();
  // Wide enough that several frames share the noise, narrow enough that the nearest one dominates.
  Eigen::VectorXd sorted = square;
  std::sort(sorted.begin(), sorted.end());
  const double width = ridge_px * ridge_px + 0.25 * sorted[sorted.size() / 2];
  const Eigen::VectorXd kernel = ((sorted[0] + width) / (square.array() + width)).square().matrix();
  Eigen::VectorXd w = weights_with(offsets, kernel, ridge_px);
  double ridge = ridge_px;
  while (!w.allFinite() || w.lpNorm<1>() > max_magnitude) {
    ridge *= 2;
    if (ridge > 1e6 * ridge_px) return kernel / kernel.sum();
    w = weights_with(offsets, kernel, ridge);
  }
  return w;
}

PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes, const Eigen::VectorXd& pose,
                               int marker_count, const std::vector<char>& without, int count) {
  // of every marker: a smaller mismatch is not worth more noise
  constexpr double kMismatchPx = 0.2;
  constexpr double kMaxWeight = 2.9;  // sum of |w|: noise and model error grow with it
  PoseNeighbours found;
  constexpr int kCandidates = 8;  // times as many
  found.rows = spread_neighbours(modes, pose,
                                 nearest_rows(modes, pose, kCandidates * count, without), count);
  const Eigen::MatrixXd points = modes(found.rows, Eigen::all);
  const double ridge_px = kMismatchPx * std::sqrt(static_cast<double>(marker_count));
  found.weights = local_linear_weights(points, pose, ridge_px, kMaxWeight);
  found.reach_px2 = reach_px2(points, pose, found.weights);
  return found;
}

namespace {

constexpr int kColumnStep = 8;
constexpr double kNearlyAll = 0.95;     // of the faces
constexpr double kPositionSdPx = 0.05;  // of an edge's smooth curve

/// Linear interpolation value_between two samples, and extrapolation beyond the last ones.
double value_between(const std::vector<float>& x, const std::vector<float>& y, std::size_t k,
                     double at) {
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
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(part * (static_cast<double>(values.size()) - 1.0));
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
  return value_between(curves.u, curves.along_mm, sample_after(curves, u), u);
}

double middle_at(const EdgeCurves& curves, double u) {
  if (curves.u.size() < 2) return 0.0;
  const std::size_t k = sample_after(curves, u);
  return 0.5 * (value_between(curves.u, curves.upper, k, u) +
                value_between(curves.u, curves.lower, k, u));
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
  const auto at_low_u = std::count_if(faces.begin(), faces.end(),
                                      [](const EdgeCurves& face) { return face.base_at_low_u; });
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
    const auto k = std::clamp<std::size_t>(static_cast<std::size_t>(after - along.begin()), 1,
                                           along.size() - 1);
    const double column = value_between(along, u, k, at_mm);
    const std::size_t sample = sample_after(curves, column);
    markers[i] = {column, value_between(curves.u, curves.upper, sample, column), true,
                  kPositionSdPx};
    markers[kPerEdge + i] = {column, value_between(curves.u, curves.lower, sample, column), true,
                             kPositionSdPx};
  }
  return markers;
}

namespace {

constexpr std::size_t kMinPoses = 8;
constexpr Eigen::Index kMaxTries = 100;  // frames from which the standard deviation is learnt

Eigen::VectorXd as_row(const Markers& markers) {
  Eigen::VectorXd row(static_cast<Eigen::Index>(2 * markers.size()));
  for (std::size_t m = 0; m < markers.size(); ++m)
    row.segment<2>(static_cast<Eigen::Index>(2 * m)) << markers[m].u, markers[m].v;
  return row;
}

}  // namespace

std::optional<ShapePoses> ShapePoses::learn(const std::vector<EdgeCurves>& faces,
                                            const Eigen::MatrixXd& layouts) {
  const auto positions = choose_edge_positions(faces);
  if (!positions) return std::nullopt;
  std::vector<Markers> seen;
  std::vector<Eigen::Index> frames;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Markers at = markers_at(*positions, faces[i]);
    if (!are_all_seen(at)) continue;
    seen.push_back(std::move(at));
    frames.push_back(static_cast<Eigen::Index>(i));
  }
  if (seen.size() < kMinPoses) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(seen.size());
  Eigen::MatrixXd shapes(count, 4 * EdgePositions::kPerEdge), recorded(count, layouts.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    shapes.row(i) = as_row(seen[static_cast<std::size_t>(i)]).transpose();
    recorded.row(i) = layouts.row(frames[static_cast<std::size_t>(i)]);
  }
  auto model =
      MarkerModel::learn(shapes, std::vector<Dot>(std::size_t{2} * EdgePositions::kPerEdge));
  if (!model) return std::nullopt;
  ShapePoses poses(*positions, std::move(*model), LayoutSearch(shapes));
  poses.layouts_ = std::move(recorded);
  poses.modes_.resize(count, poses.model_.mode_sd_px().size());
  for (Eigen::Index i = 0; i < count; ++i)
    poses.modes_.row(i) = poses.model_.modes(seen[static_cast<std::size_t>(i)])
                              .cwiseProduct(poses.model_.mode_sd_px())
                              .transpose();
  poses.known_px_ = known_distance_px(poses.search_);
  poses.learn_sd();
  return poses;
}

Eigen::VectorXd ShapePoses::layout_at(const Eigen::VectorXd& pose,
                                      const std::vector<char>& without) const {
  const PoseNeighbours near = pose_neighbours(modes_, pose, model_.marker_count(), without);
  Eigen::VectorXd layout = Eigen::VectorXd::Zero(layouts_.cols());
  for (std::size_t i = 0; i < near.rows.size(); ++i)
    layout += near.weights[static_cast<Eigen::Index>(i)] * layouts_.row(near.rows[i]).transpose();
  return layout;
}

void ShapePoses::learn_sd() {
  const Eigen::Index step = std::max<Eigen::Index>(1, layouts_.rows() / kMaxTries);
  Eigen::VectorXd square = Eigen::VectorXd::Zero(layouts_.cols());
  std::vector<char> without(static_cast<std::size_t>(layouts_.rows()), 0);
  int tries = 0;
  for (Eigen::Index i = 0; i < layouts_.rows(); i += step, ++tries) {
    without[static_cast<std::size_t>(i)] = 1;
    const Eigen::VectorXd estimate = layout_at(modes_.row(i).transpose(), without);
    without[static_cast<std::size_t>(i)] = 0;
    square += (estimate - layouts_.row(i).transpose()).cwiseAbs2();
  }
  sd_px_.resize(static_cast<std::size_t>(layouts_.cols() / 2));
  for (std::size_t m = 0; m < sd_px_.size(); ++m)
    sd_px_[m] = std::sqrt(square.segment<2>(static_cast<Eigen::Index>(2 * m)).sum() / (2 * tries));
}

std::optional<ShapePoses::Estimate> ShapePoses::operator()(const FaceShape& shape) const {
  const auto seen = model_.complete(markers_at(positions_, edge_curves(shape)));
  if (!seen) return std::nullopt;
  const Eigen::VectorXd pose = model_.modes(*seen).cwiseProduct(model_.mode_sd_px());
  const Eigen::VectorXd layout = layout_at(pose, {});
  Estimate estimate;
  estimate.distance_px = search_.nearest(*seen).distance_px;
  estimate.known_pose = estimate.distance_px <= known_px_;
  for (std::size_t m = 0; m < sd_px_.size(); ++m) {
    const auto k = static_cast<Eigen::Index>(2 * m);
    estimate.markers.push_back({layout[k], layout[k + 1], false, sd_px_[m]});
  }
  return estimate;
}

}  // namespace alltact
