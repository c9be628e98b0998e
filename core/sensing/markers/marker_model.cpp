#include "core/sensing/markers/marker_model.h"

#include "core/numerics/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kMaxGapModes = 6;
constexpr int kPasses = 12;
constexpr int kLocalPasses = 4;
constexpr std::size_t kEnoughRows = 40;
constexpr double kNoisePx = 0.1;

std::vector<Eigen::Index> seen_coordinates(const Eigen::MatrixXd& layouts, Eigen::Index row) {
  std::vector<Eigen::Index> seen;
  for (Eigen::Index k = 0; k < layouts.cols(); ++k)
    if (std::isfinite(layouts(row, k))) seen.push_back(k);
  return seen;
}

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& layouts, const std::vector<Eigen::Index>& rows) {
  Eigen::MatrixXd selected(static_cast<Eigen::Index>(rows.size()), layouts.cols());
  for (std::size_t i = 0; i < rows.size(); ++i)
    selected.row(static_cast<Eigen::Index>(i)) = layouts.row(rows[i]);
  return selected;
}

/// Initial value: the mean position of the marker, shifted like the row's seen markers.
void fill_by_shift(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(filled.cols()), count = mean;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (const Eigen::Index k : seen[i])
      mean[k] += filled(static_cast<Eigen::Index>(i), k), ++count[k];
  mean = mean.cwiseQuotient(count.cwiseMax(1.0));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    const auto row = static_cast<Eigen::Index>(i);
    for (const Eigen::Index k : seen[i]) shift[k % 2] += filled(row, k) - mean[k];
    shift /= 0.5 * static_cast<double>(seen[i].size());
    for (Eigen::Index k = 0; k < filled.cols(); ++k)
      if (!std::isfinite(filled(row, k))) filled(row, k) = mean[k] + shift[k % 2];
  }
}

/// One pass: the modes of all rows, then each row's gaps from its seen coordinates.
void refine(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  const Eigen::Index n = filled.rows(), size = filled.cols();
  const Eigen::VectorXd mean = filled.colwise().mean().transpose();
  const Eigen::MatrixXd centred = filled.rowwise() - mean.transpose();
  const auto eigen = symmetric_eigen(centred.transpose() * centred / static_cast<double>(n - 1));
  const Eigen::Index modes = std::min<Eigen::Index>({kMaxGapModes, n - 1, size});
  const Eigen::VectorXd values = eigen.eigenvalues().tail(modes).cwiseMax(1e-6);
  const Eigen::MatrixXd basis = eigen.eigenvectors().rightCols(modes);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (static_cast<Eigen::Index>(seen[i].size()) == size) continue;
    Eigen::MatrixXd a = (kNoisePx * kNoisePx / values.array()).matrix().asDiagonal();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(modes);
    for (const Eigen::Index k : seen[i]) {
      a.noalias() += basis.row(k).transpose() * basis.row(k);
      b.noalias() += basis.row(k).transpose() * centred(row, k);
    }
    const Eigen::VectorXd layout = mean + basis * a.ldlt().solve(b);
    std::size_t next = 0;
    for (Eigen::Index k = 0; k < size; ++k) {
      if (next < seen[i].size() && seen[i][next] == k)
        ++next;
      else
        filled(row, k) = layout[k];
    }
  }
}

/// Fills gaps from the nearest rows, which follow the bending where one set of modes cannot.
void refine_locally(const std::vector<std::vector<Eigen::Index>>& seen, Eigen::MatrixXd& filled) {
  const Eigen::MatrixXd before = filled;
  std::vector<char> without(seen.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (static_cast<Eigen::Index>(seen[i].size()) == filled.cols()) continue;
    without[i] = 1;
    const auto neighbours =
        nearest_rows(before, before.row(row).transpose(), kLocalNeighbours, without);
    without[i] = 0;
    if (neighbours.size() < 2) continue;
    Markers markers(static_cast<std::size_t>(filled.cols() / 2));
    for (const Eigen::Index k : seen[i])
      markers[static_cast<std::size_t>(k / 2)] = {before(row, k / 2 * 2),
                                                  before(row, k / 2 * 2 + 1), true, 0};
    const LocalLayout local(before, neighbours, markers, kNoisePx);
    for (std::size_t m = 0; m < markers.size(); ++m)
      if (!markers[m].seen)
        filled.row(row).segment<2>(static_cast<Eigen::Index>(2 * m)) =
            local.position(static_cast<int>(m)).transpose();
  }
}

/// layouts: one row a frame, (u0, v0, u1, ...), px; NaN where not seen. Returns the complete rows
/// where these suffice: 40, and two thirds of the rows that show at least half of the markers, or
/// all rows. Otherwise returns all rows that show at least half, with filled gaps. Expectation
/// maximisation fills them: principal modes of all rows and their fit to each row's seen markers
/// alternate. Then the rows nearest to each refine them. Returns no rows when
/// fewer than 2 are usable, or when a marker is in none of them.
Eigen::MatrixXd without_gaps(const Eigen::MatrixXd& layouts) {
  std::vector<Eigen::Index> complete, usable;
  std::vector<std::vector<Eigen::Index>> seen;
  Eigen::VectorXi count = Eigen::VectorXi::Zero(layouts.cols());
  for (Eigen::Index i = 0; i < layouts.rows(); ++i) {
    auto coordinates = seen_coordinates(layouts, i);
    const auto known = static_cast<Eigen::Index>(coordinates.size());
    if (known == layouts.cols()) complete.push_back(i);
    if (known < 4 || 2 * known < layouts.cols()) continue;
    usable.push_back(i);
    for (const Eigen::Index k : coordinates) ++count[k];
    seen.push_back(std::move(coordinates));
  }
  const bool is_plenty = complete.size() >= kEnoughRows && 3 * complete.size() >= 2 * usable.size();
  if (complete.size() >= 2 && (is_plenty || complete.size() == usable.size()))
    return rows_of(layouts, complete);
  if (usable.size() < 2 || count.minCoeff() == 0) return rows_of(layouts, {});
  Eigen::MatrixXd filled = rows_of(layouts, usable);
  fill_by_shift(seen, filled);
  for (int pass = 0; pass < kPasses; ++pass) refine(seen, filled);
  for (int pass = 0; pass < kLocalPasses; ++pass) refine_locally(seen, filled);
  return filled;
}

// A Fin Ray bends, sways and twists; further modes are noise
constexpr int kMaxModes = 8;
constexpr int kCovering = 160;            // layouts that the search for a pose starts from
constexpr int kStarts = 10;               // number of these that are refined
constexpr double kContradictionPx = 0.5;  // smaller contradictions are harmless
constexpr double kFloorPx = 0.05;         // noise of even a perfect recording

Eigen::Vector2d position_of(const Eigen::VectorXd& layout, int marker) {
  return layout.segment<2>(Eigen::Index{2} * marker);
}

// Smallest distance of neighbours in a row; with one dot a row, a quarter of the distance between
// the rows.
double smallest_spacing(const Eigen::MatrixXd& layouts) {
  const Eigen::Index per_row = layouts.cols() / 4;
  if (per_row == 1) {
    const Eigen::MatrixXd across = layouts.rightCols(2) - layouts.leftCols(2);
    return std::max(1.0, 0.25 * across.rowwise().norm().minCoeff());
  }
  double min_spacing = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < layouts.rows(); ++i)
    for (Eigen::Index m = 0; m + 1 < 2 * per_row; ++m) {
      if (m + 1 == per_row) continue;  // from the end of one row to the start of the other
      const auto step = layouts.row(i).segment<2>(2 * m + 2) - layouts.row(i).segment<2>(2 * m);
      min_spacing = std::min(min_spacing, step.norm());
    }
  return std::isfinite(min_spacing) ? std::max(min_spacing, 1.0) : 1.0;
}

Markers markers_from(const std::vector<Dot>& dots, const std::vector<int>& dot_of) {
  Markers markers(dot_of.size());
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (dot_of[m] < 0) continue;
    const Dot& dot = dots[static_cast<std::size_t>(dot_of[m])];
    markers[m] = {dot.u, dot.v, true, dot.sd_px};
  }
  return markers;
}

// Assigns dots at the estimated positions of hidden markers; true when there was one.
bool add_unused(const std::vector<Dot>& dots, double gate, const std::vector<char>& missing,
                Markers& markers) {
  bool added = false;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    Marker& marker = markers[m];
    if (marker.seen || missing[m]) continue;
    for (const Dot& dot : dots) {
      const bool same_side = dot.upper == (2 * m < markers.size());
      const auto is_this = [&](const Marker& other) {
        return other.seen && other.u == dot.u && other.v == dot.v;
      };
      if (!same_side || std::hypot(dot.u - marker.u, dot.v - marker.v) > gate) continue;
      if (std::any_of(markers.begin(), markers.end(), is_this)) continue;
      marker = {dot.u, dot.v, true, dot.sd_px};
      added = true;
      break;
    }
  }
  return added;
}

}  // namespace

// Numbered dots and the layout of the modes fitted to them.
struct MarkerModel::Pose {
  std::vector<int> dot_of;  // by marker, -1: none
  Eigen::VectorXd layout;
  int assigned = 0;
};

Result<MarkerModel> MarkerModel::learn(const Eigen::MatrixXd& layouts,
                                       const std::vector<Dot>& typical_dots,
                                       const std::vector<int>& missing) {
  MarkerModel model;
  model.layouts_ = without_gaps(layouts);
  const Eigen::Index n = model.layouts_.rows(), size = layouts.cols();
  if (n < 2 || size < 4 || size % 4 != 0)
    return Error{en::say("only {} recorded images show every marker; at least 2 are needed", n),
                 en::say("marker model"),
                 en::say("record the finger bending with both side faces in view and evenly lit")};
  if (static_cast<Eigen::Index>(typical_dots.size()) * 2 != size)
    return Error{
        en::say("{} markers have a position but {} have a size", size / 2, typical_dots.size()),
        en::say("marker model"), en::say("record the reference again")};
  model.typical_ = typical_dots;
  model.missing_.assign(typical_dots.size(), 0);
  for (const int marker : missing) model.missing_[static_cast<std::size_t>(marker)] = 1;
  model.present_ = static_cast<int>(std::count(model.missing_.begin(), model.missing_.end(), 0));
  model.mean_ = model.layouts_.colwise().mean().transpose();
  const Eigen::MatrixXd centred = model.layouts_.rowwise() - model.mean_.transpose();
  const Eigen::MatrixXd covariance = centred.transpose() * centred / static_cast<double>(n - 1);
  const auto eigen = symmetric_eigen(covariance);
  if (eigen.info() != Eigen::Success)
    return Error{en::say("the markers' positions are not finite numbers"), en::say("marker model"),
                 en::say("record the reference again")};
  const Eigen::VectorXd values = eigen.eigenvalues().cwiseMax(0.0);
  // Number of modes that the existing dots determine, less a few that check the fit.
  const auto determined =
      std::max<Eigen::Index>(std::min(3, 2 * model.present_ - 1), 2 * model.present_ - 4);
  // Half of all eigenvalues are noise where there are enough layouts; of few markers, those that
  // cannot be modes.
  const Eigen::Index quiet = std::min(size / 2, std::max<Eigen::Index>(0, size - 1 - determined));
  const double noise =
      n > size / 2 ? values[size > Eigen::Index{2} * kMaxModes ? size / 2 : quiet] : 0.0;
  const int max_modes = static_cast<int>(std::min<Eigen::Index>({kMaxModes, n - 1, determined}));
  int modes = 1;
  while (modes < max_modes && values[size - 1 - modes] > 4 * noise + kFloorPx * kFloorPx) ++modes;
  model.basis_.resize(size, modes);
  model.mode_sd_.resize(modes);
  for (int k = 0; k < modes; ++k) {
    model.basis_.col(k) = eigen.eigenvectors().col(size - 1 - k);
    model.mode_sd_[k] = std::sqrt(values[size - 1 - k] + kFloorPx * kFloorPx);
  }
  model.mode_coordinates_ = centred * model.basis_;
  model.covering_ = farthest_point_order(model.mode_coordinates_, kCovering);
  model.spacing_px_ = smallest_spacing(model.layouts_);
  model.learn_noise();
  return model;
}

void MarkerModel::learn_noise() {
  // Estimates layouts from their neighbours, marker by marker, and scales the noise until the
  // discrepancies have unit variance. In a sparse recording it is mostly the bending between
  // frames.
  const Eigen::Index step = std::max<Eigen::Index>(1, layouts_.rows() / 60);
  noise_px_ = kFloorPx;
  std::vector<char> without(static_cast<std::size_t>(layouts_.rows()), 0);
  for (int pass = 0; pass < 3; ++pass) {
    double square = 0;
    int count = 0;
    for (Eigen::Index i = 0; i < layouts_.rows(); i += step) {
      Markers markers(static_cast<std::size_t>(marker_count()));
      for (Eigen::Index m = 0; m < marker_count(); ++m)
        markers[static_cast<std::size_t>(m)] = {layouts_(i, 2 * m), layouts_(i, 2 * m + 1), true,
                                                0};
      without[static_cast<std::size_t>(i)] = 1;
      const auto neighbours = nearest_rows(mode_coordinates_, mode_coordinates_.row(i).transpose(),
                                           kLocalNeighbours, without);
      without[static_cast<std::size_t>(i)] = 0;
      if (neighbours.size() < 2) continue;
      const LocalLayout local(layouts_, neighbours, markers, noise_px_);
      for (int m = 0; m < marker_count(); ++m) {
        const double sigmas =
            local.discrepancy(m, position_of(layouts_.row(i).transpose(), m)).sigmas;
        square += sigmas * sigmas;
      }
      count += 2 * marker_count();
    }
    if (count == 0) return;
    noise_px_ =
        std::clamp(noise_px_ * std::sqrt(square / count), kFloorPx, 0.05 * spacing_px_ + kFloorPx);
  }
}

Eigen::VectorXd MarkerModel::fit_modes(const Markers& markers) const {
  const Eigen::Index modes = basis_.cols();
  // Poses up to three times as far out as the recording's cost little; the noise term regularises
  // undetermined modes to the mean.
  Eigen::MatrixXd a =
      (noise_px_ * noise_px_ / (9 * mode_sd_.array().square())).matrix().asDiagonal();
  Eigen::VectorXd b = Eigen::VectorXd::Zero(modes);
  for (int m = 0; m < marker_count(); ++m) {
    const Marker& marker = markers[static_cast<std::size_t>(m)];
    if (!marker.seen) continue;
    const auto rows = basis_.middleRows(Eigen::Index{2} * m, 2);
    a.noalias() += rows.transpose() * rows;
    b.noalias() += rows.transpose() * (Eigen::Vector2d(marker.u, marker.v) - position_of(mean_, m));
  }
  return a.ldlt().solve(b);
}

std::vector<int> MarkerModel::likeliest_layouts(const std::vector<Dot>& dots) const {
  const double gate = 0.6 * spacing_px_;
  std::vector<std::pair<double, int>> scores;
  for (const int row : covering_) {
    double score = 0;
    for (int m = 0; m < marker_count(); ++m) {
      if (is_missing(m)) continue;
      const Eigen::Index at = Eigen::Index{2} * m;
      const double u = layouts_(row, at), v = layouts_(row, at + 1);
      double nearest = gate * gate;
      for (const Dot& dot : dots) {
        const double square = (dot.u - u) * (dot.u - u) + (dot.v - v) * (dot.v - v);
        if (dot.upper == (2 * m < marker_count()) && square < nearest) nearest = square;
      }
      score += 1 - nearest / (gate * gate);
    }
    scores.emplace_back(-score, row);
  }
  std::sort(scores.begin(), scores.end());
  std::vector<int> rows;
  for (const auto& [score, row] : scores)
    if (static_cast<int>(rows.size()) < kStarts) rows.push_back(row);
  return rows;
}

MarkerModel::Pose MarkerModel::explain(const std::vector<Dot>& dots, Eigen::VectorXd layout) const {
  struct Pair {
    double distance;
    int marker, dot;
  };
  const double last_gate = std::min(0.3 * spacing_px_, std::max(3.0, 8 * noise_px_));
  Pose pose;
  for (const double gate :
       {0.7 * spacing_px_, 0.6 * spacing_px_, 0.5 * spacing_px_, 0.4 * spacing_px_,
        std::max(last_gate, 0.25 * spacing_px_), last_gate, last_gate}) {
    std::vector<Pair> pairs;
    for (int m = 0; m < marker_count(); ++m)
      for (std::size_t d = 0; d < dots.size() && !is_missing(m); ++d) {
        if (dots[d].upper != (2 * m < marker_count())) continue;
        const double distance =
            (Eigen::Vector2d(dots[d].u, dots[d].v) - position_of(layout, m)).norm();
        if (distance < gate) pairs.push_back({distance, m, static_cast<int>(d)});
      }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return std::tie(a.distance, a.marker, a.dot) < std::tie(b.distance, b.marker, b.dot);
    });
    pose = Pose{std::vector<int>(static_cast<std::size_t>(marker_count()), -1), {}, 0};
    std::vector<char> taken(dots.size(), 0);
    Markers markers(static_cast<std::size_t>(marker_count()));
    for (const Pair& pair : pairs) {
      const auto m = static_cast<std::size_t>(pair.marker), d = static_cast<std::size_t>(pair.dot);
      if (pose.dot_of[m] >= 0 || taken[d]) continue;
      pose.dot_of[m] = pair.dot;
      taken[d] = 1;
      markers[m] = {dots[d].u, dots[d].v, true, dots[d].sd_px};
      ++pose.assigned;
    }
    if (pose.assigned < 2) return pose;
    layout = mean_ + basis_ * fit_modes(markers);
    pose.layout = layout;
  }
  return pose;
}

std::optional<Markers> MarkerModel::number(const std::vector<Dot>& dots) const {
  std::optional<Markers> best;
  double best_score = 0;
  std::vector<std::vector<int>> tried;
  for (const int row : likeliest_layouts(dots)) {
    const Pose pose = explain(dots, layouts_.row(row).transpose());
    if (pose.assigned < minimum_seen()) continue;
    if (std::find(tried.begin(), tried.end(), pose.dot_of) != tried.end()) continue;
    tried.push_back(pose.dot_of);
    const auto markers = complete(markers_from(dots, pose.dot_of));
    if (!markers) continue;
    // A row shifted by one finds nearly as many dots, but the recorded layouts do not bend so.
    const double worth = seen_count(*markers) - residual_px(*markers) / (0.1 * spacing_px_);
    if (!best || worth > best_score) best = markers, best_score = worth;
  }
  if (!best) return std::nullopt;
  return add_unused(dots, std::max(1.0, 5 * noise_px_), missing_, *best) ? complete(*best) : best;
}

LocalLayout MarkerModel::local_layout(const Markers& markers) const {
  return {layouts_, nearest_rows(mode_coordinates_, fit_modes(markers), kLocalNeighbours), markers,
          noise_px_};
}

std::optional<Markers> MarkerModel::complete(Markers markers) const {
  if (static_cast<int>(markers.size()) != marker_count()) return std::nullopt;
  for (std::size_t m = 0; m < markers.size(); ++m)
    markers[m].seen = markers[m].seen && !missing_[m] && std::isfinite(markers[m].u) &&
                      std::isfinite(markers[m].v);
  const int max_refused = present_ / 3;
  for (int refused = 0;; ++refused) {
    if (seen_count(markers) < minimum_seen()) return std::nullopt;
    const LocalLayout local = local_layout(markers);
    double worst = 0;
    std::size_t worst_marker = 0;
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (!markers[m].seen) continue;
      const auto off = local.discrepancy(static_cast<int>(m), {markers[m].u, markers[m].v});
      if (off.px > kContradictionPx && off.sigmas > worst) worst = off.sigmas, worst_marker = m;
    }
    // In a pose beyond the recording every marker is slightly off. Only a marker without which the
    // rest agrees far better is an outlier.
    const double others =
        std::max(1.0, 2.0 * (seen_count(markers) - 1) - static_cast<double>(basis_.cols()));
    const double rest = std::max(1.0, (local.misfit() - worst * worst) / others);
    if (worst < 6.0 || worst * worst < 8.0 * rest || refused >= max_refused) {
      for (int m = 0; m < marker_count(); ++m) {
        Marker& marker = markers[static_cast<std::size_t>(m)];
        if (marker.seen) continue;
        const Eigen::Vector2d position = local.position(m);
        marker = {position.x(), position.y(), false, std::hypot(local.sd_px(m), noise_px_)};
      }
      return markers;
    }
    markers[worst_marker].seen = false;
  }
}

std::optional<Eigen::MatrixXd> MarkerModel::covariance_px2(const Markers& markers) const {
  if (static_cast<int>(markers.size()) != marker_count() || seen_count(markers) == 0)
    return std::nullopt;
  return local_layout(markers).covariance_px2(markers);
}

Eigen::VectorXd MarkerModel::modes(const Markers& markers) const {
  Eigen::VectorXd layout(mean_.size());
  for (int m = 0; m < marker_count(); ++m) {
    const Marker& marker = markers[static_cast<std::size_t>(m)];
    layout.segment<2>(Eigen::Index{2} * m) << marker.u, marker.v;
  }
  return (basis_.transpose() * (layout - mean_)).cwiseQuotient(mode_sd_);
}

double MarkerModel::residual_px(const Markers& markers) const {
  const Eigen::VectorXd layout = mean_ + basis_ * fit_modes(markers);
  double square = 0;
  int count = 0;
  for (int m = 0; m < marker_count(); ++m) {
    const Marker& marker = markers[static_cast<std::size_t>(m)];
    if (!marker.seen) continue;
    square += (Eigen::Vector2d(marker.u, marker.v) - position_of(layout, m)).squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(square / count) : 0.0;
}

std::vector<int> nearest_rows(const Eigen::MatrixXd& points, const Eigen::VectorXd& query,
                              int count, const std::vector<char>& without) {
  Eigen::VectorXd square = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index k = 0; k < points.cols(); ++k)
    square.array() += (points.col(k).array() - query[k]).square();
  std::vector<int> rows(static_cast<std::size_t>(points.rows()));
  std::iota(rows.begin(), rows.end(), 0);
  if (!without.empty())
    std::erase_if(rows, [&](int row) { return without[static_cast<std::size_t>(row)] != 0; });
  const auto selected = std::min(rows.size(), static_cast<std::size_t>(std::max(0, count)));
  const auto nearer = [&](int a, int b) {
    return square[a] < square[b] || (square[a] == square[b] && a < b);
  };
  std::partial_sort(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(selected), rows.end(),
                    nearer);
  rows.resize(selected);
  return rows;
}

LocalLayout::LocalLayout(const Eigen::MatrixXd& layouts, const std::vector<int>& neighbours,
                         const Markers& markers, double noise_px)
    : noise_px_(noise_px) {
  const Eigen::Index size = layouts.cols(), count = static_cast<Eigen::Index>(neighbours.size());
  deviations_.resize(size, count);
  for (Eigen::Index k = 0; k < count; ++k)
    deviations_.col(k) = layouts.row(neighbours[static_cast<std::size_t>(k)]).transpose();
  const Eigen::VectorXd mean = deviations_.rowwise().mean();
  deviations_.colwise() -= mean;

  const double noise = noise_px * noise_px;
  // Coefficients of sd 2 / sqrt(count) give the neighbours' own covariance, twice as wide.
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(count, count) * (0.25 * static_cast<double>(count));
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
  double square = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    if (!markers[m].seen) continue;
    const auto i = static_cast<Eigen::Index>(2 * m);
    const auto rows = deviations_.middleRows(i, 2);
    information.noalias() += rows.transpose() * rows / noise;
    const Eigen::Vector2d off = Eigen::Vector2d(markers[m].u, markers[m].v) - mean.segment<2>(i);
    pull.noalias() += rows.transpose() * off / noise;
    square += off.squaredNorm() / noise;
  }
  covariance_ = information.llt().solve(Eigen::MatrixXd::Identity(count, count));
  const Eigen::VectorXd coefficients = covariance_ * pull;
  position_ = mean + deviations_ * coefficients;
  misfit_ = std::max(0.0, square - pull.dot(coefficients));
}

double LocalLayout::sd_px(int marker) const {
  const auto rows = deviations_.middleRows(Eigen::Index{2} * marker, 2);
  const Eigen::Matrix2d spread = rows * covariance_ * rows.transpose();
  return std::sqrt(std::max({0.0, spread(0, 0), spread(1, 1)}));
}

LocalLayout::Discrepancy LocalLayout::discrepancy(int marker, const Eigen::Vector2d& seen) const {
  const auto rows = deviations_.middleRows(Eigen::Index{2} * marker, 2);
  const double noise = noise_px_ * noise_px_;
  // Leaving one observation out of a linear fit divides its residual by (1 - its leverage).
  const Eigen::Matrix2d left =
      Eigen::Matrix2d::Identity() - rows * covariance_ * rows.transpose() / noise;
  const Eigen::Vector2d residual = seen - position(marker);
  const Eigen::Vector2d left_out = left.inverse() * residual;
  return {left_out.norm(), std::sqrt(std::max(0.0, residual.dot(left_out)) / noise)};
}

Eigen::MatrixXd LocalLayout::covariance_px2(const Markers& markers) const {
  const Eigen::Index size = deviations_.rows(), count = deviations_.cols();
  std::vector<Eigen::Index> seen, hidden;  // indices of coordinates
  Eigen::VectorXd own = Eigen::VectorXd::Zero(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Marker& marker = markers[static_cast<std::size_t>(k / 2)];
    (marker.seen ? seen : hidden).push_back(k);
    if (marker.seen) own[k] = marker.sd_px * marker.sd_px;
  }
  Eigen::MatrixXd result = own.asDiagonal();
  if (hidden.empty()) return result;
  const double noise = noise_px_ * noise_px_;
  const double seen_variance = seen.empty() ? 0.0 : own.sum() / static_cast<double>(seen.size());
  const double off_mixture = std::max(0.0, noise - seen_variance);
  const Eigen::MatrixXd hidden_rows = deviations_(hidden, Eigen::all);
  const Eigen::MatrixXd gain =  // response of hidden coordinates to seen ones
      hidden_rows * covariance_ * deviations_(seen, Eigen::all).transpose() / noise;
  const Eigen::VectorXd seen_own = own(seen);
  // The ridge prior is twice as wide as the neighbours' spread.
  const Eigen::MatrixXd pulled = hidden_rows * covariance_ * (0.25 * std::sqrt(count));
  const Eigen::MatrixXd shared = gain * seen_own.asDiagonal();
  result(hidden, seen) = shared;
  result(seen, hidden) = shared.transpose();
  Eigen::MatrixXd among = shared * gain.transpose() + off_mixture * gain * gain.transpose() +
                          pulled * pulled.transpose();
  among.diagonal().array() += off_mixture;
  result(hidden, hidden) = among;
  return result;
}

}  // namespace alltact
